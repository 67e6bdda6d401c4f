// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <rosbag/bag.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace smore {

/// What a record follows of other nodes: what the maps follow from, and what is shown of them and
/// of the plans.
std::vector<std::string> recordedTopics();

/// The header of a connection of one's own on which the newest message is kept for who comes later.
template <typename Message>
boost::shared_ptr<ros::M_string> latchingHeaderOf(const Message& message) {
  namespace traits = ros::message_traits;
  return boost::make_shared<ros::M_string>(
      ros::M_string{{"latching", "1"},
                    {"md5sum", traits::md5sum(message)},
                    {"message_definition", traits::definition(message)},
                    {"type", traits::datatype(message)}});
}

/// A bag of what a node is given, in the order in which it is: nothing of it is missing, whenever
/// the node begins. Written by a thread of its own, so that nobody waits for the disk.
class SensingRecord {
 public:
  /// A new file, in a directory that is made where it is missing. std::runtime_error where it
  /// cannot be written.
  explicit SensingRecord(const std::string& file);
  /// Writes what is still queued and closes the bag.
  ~SensingRecord();

  /// Adds a message as of now. `header`: of the connection that it came by, so that what is played
  /// is latched where it was; null for one of our own.
  template <typename Message>
  void add(const std::string& topic, const Message& message,
           const boost::shared_ptr<ros::M_string>& header = nullptr) {
    push([this, topic, message, header, time = nextTime()] {
      bag_->write(topic, time, message, header);
    });
  }

  /// Adds what comes on a topic from now on, of whatever type; `node`: whose queue is called by the
  /// thread that adds.
  void follow(const std::string& topic, ros::NodeHandle* node);

  /// Why nothing is written any more; empty where all is well.
  std::string problem() const;

 private:
  ros::Time nextTime();
  void push(std::function<void()> write);
  void work();

  /// Closes the bag; where the disk is full it stays as it is.
  void close();

  std::unique_ptr<rosbag::Bag> bag_ = std::make_unique<rosbag::Bag>();
  std::vector<ros::Subscriber> followed_;
  ros::Time last_time_ = ros::TIME_MIN;
  mutable std::mutex mutex_;
  std::condition_variable queued_;
  std::deque<std::function<void()>> queue_;
  bool ending_ = false;
  std::string problem_;
  std::thread worker_;
};

}  // namespace smore
