// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/map_keeper.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "smore/common/result.h"

namespace smore {
namespace {

/// Whether the observation was news. std::out_of_range, and nothing changes, where it does not fit
/// into the maps.
bool learn(const ContactObservation& observation, MapState* state) {
  if (!state->log.add(observation)) return false;
  try {
    state->maps->observe(observation);
  } catch (const std::out_of_range&) {
    state->log.dropLast();
    throw;
  }
  if (observation.line) state->lines.push_back(*observation.line);
  return true;
}

}  // namespace

MapKeeper::MapKeeper(MakeMaps make_maps, const EvidenceSpacing& spacing,
                     std::unique_ptr<EvidenceJournal> journal)
    : make_maps_(std::move(make_maps)),
      spacing_(spacing),
      state_{make_maps_(), EvidenceLog(spacing), {}, 0, 0.0},
      journal_(std::move(journal)) {
  state_.first_revision = state_.maps->revision();  // what is known beforehand is no change
  writeJournal([this] { journal_->begin({}); });
  worker_ = std::thread([this] { work(); });
}

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
  writeJournal([this] { journal_->begin({}); });
}

void MapKeeper::load(const std::vector<ContactObservation>& observations) {
  MapState loaded{make_maps_(), EvidenceLog(spacing_), {}, 0, 0.0};
  loaded.first_revision = loaded.maps->revision();
  int contacts = 0;
  try {
    for (const ContactObservation& observation : observations) {
      contacts = std::max(contacts, observation.contact_id);
      learn(observation, &loaded);
    }
  } catch (const std::out_of_range& error) {
    throw InputError(std::string("an observation lies outside of the maps (") + error.what() +
                     "); use larger voxels");
  }
  const std::scoped_lock lock(queue_mutex_, state_mutex_);
  queue_.clear();
  numbering_.continueAfter(contacts);
  loaded.log.continueAfter(state_.log.epoch());
  loaded.stamp = state_.stamp;
  state_ = std::move(loaded);
  writeJournal([this] { journal_->begin(state_.log.from(0)); });
}

std::optional<std::string> MapKeeper::takeProblem() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return std::exchange(problem_, std::nullopt);
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

void MapKeeper::take(ContactObservation observation) {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    observation.contact_id = numbering_.numberOf(observation.contact_id);
    takeIn(observation);
    state_.stamp = observation.time;
  }
  taken_.notify_all();
}

void MapKeeper::takeIn(const ContactObservation& observation) {
  try {
    if (!learn(observation, &state_)) return;
  } catch (const std::out_of_range& error) {
    problem_ = std::string("observation left out: it lies outside of the maps (") + error.what() +
               "); check tf, or use larger voxels";
    return;
  }
  writeJournal([&] { journal_->observe(observation); });
}

void MapKeeper::writeJournal(const std::function<void()>& write) {
  if (!journal_) return;
  try {
    write();
  } catch (const std::runtime_error& error) {
    problem_ = std::string(error.what()) + "; the journal ends here";
    journal_.reset();
  }
}

}  // namespace smore
