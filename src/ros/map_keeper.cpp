// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/map_keeper.h"

#include <chrono>
#include <utility>

namespace smore {

MapKeeper::MapKeeper(std::unique_ptr<TwinMap> maps, const EvidenceSpacing& spacing)
    : state_{std::move(maps), EvidenceLog(spacing), {}, 0, 0.0}, worker_([this] { work(); }) {}

MapKeeper::~MapKeeper() {
  {
    const std::lock_guard<std::mutex> lock(queue_mutex_);
    ending_ = true;
  }
  queued_.notify_all();
  worker_.join();
}

void MapKeeper::push(const ContactObservation& observation) {
  {
    const std::lock_guard<std::mutex> lock(queue_mutex_);
    queue_.push_back(observation);
  }
  queued_.notify_one();
}

void MapKeeper::access(const std::function<void(const MapState&)>& read) const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  read(state_);
}

bool MapKeeper::waitFor(double stamp, double timeout) const {
  std::unique_lock<std::mutex> lock(state_mutex_);
  return taken_.wait_for(lock, std::chrono::duration<double>(timeout),
                         [&] { return state_.stamp >= stamp; });
}

void MapKeeper::reset() {
  const std::scoped_lock lock(queue_mutex_, state_mutex_);
  queue_.clear();
  state_.maps->reset();
  state_.log.restart();
  state_.lines.clear();
  state_.first_revision = state_.maps->revision();
}

void MapKeeper::work() {
  std::unique_lock<std::mutex> lock(queue_mutex_);
  while (!ending_) {
    if (queue_.empty()) {
      queued_.wait(lock);
      continue;
    }
    const ContactObservation observation = queue_.front();
    queue_.pop_front();
    lock.unlock();
    take(observation);
    lock.lock();
  }
}

void MapKeeper::take(const ContactObservation& observation) {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    if (state_.log.add(observation)) {
      state_.maps->observe(observation);
      if (observation.line) state_.lines.push_back(*observation.line);
    }
    state_.stamp = observation.time;
  }
  taken_.notify_all();
}

}  // namespace smore
