// SPDX-License-Identifier: BSD-3-Clause
#include "sensing_record.h"

#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "smore/ros/names.h"

namespace smore {

std::vector<std::string> recordedTopics() {
  const std::string cells = std::string("/") + names::kOccupiedCells;
  return {names::kEvidenceSource,    names::kScene,       names::kWorldMap + cells,
          names::kObjectMap + cells, names::kPathMarkers, names::kContactLines};
}

SensingRecord::SensingRecord(const std::string& file) {
  std::error_code problem;
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), problem);
  try {
    bag_->open(file, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error("record: '" + file + "' cannot be written: " + error.what());
  }
  worker_ = std::thread([this] { work(); });
}

SensingRecord::~SensingRecord() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  queued_.notify_all();
  worker_.join();
  close();
}

// Its destructor would try again, and throw.
void SensingRecord::close() {
  try {
    bag_->close();
  } catch (const rosbag::BagException&) {
    (void)bag_.release();
  }
}

void SensingRecord::follow(const std::string& topic, ros::NodeHandle* node) {
  using Event = ros::MessageEvent<topic_tools::ShapeShifter>;
  const boost::function<void(const Event&)> keep =
      [this, name = node->resolveName(topic)](const Event& event) {
        add(name, *event.getConstMessage(), event.getConnectionHeaderPtr());
      };
  followed_.push_back(node->subscribe<topic_tools::ShapeShifter>(topic, names::kStreamQueue, keep));
}

std::string SensingRecord::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

// Rising, so that what is read by time comes in the order in which it was given.
ros::Time SensingRecord::nextTime() {
  last_time_ = std::max(ros::Time::now(), last_time_ + ros::Duration(0, 1));
  return last_time_;
}

void SensingRecord::push(std::function<void()> write) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!problem_.empty()) return;
    queue_.push_back(std::move(write));
  }
  queued_.notify_one();
}

void SensingRecord::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_ || !queue_.empty()) {
    if (queue_.empty()) {
      queued_.wait(lock);
      continue;
    }
    const std::function<void()> write = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    std::string problem;
    try {
      write();
    } catch (const rosbag::BagException& error) {
      problem = error.what();
    }
    lock.lock();
    if (problem.empty()) continue;
    problem_ = problem;
    queue_.clear();
  }
}

}  // namespace smore
