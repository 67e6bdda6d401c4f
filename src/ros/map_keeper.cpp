// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/map_keeper.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "smore/common/result.h"
#include "smore/mapping/learnt_matter.h"
#include "smore/mapping/prior_evidence.h"

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

/// Of no other process: who follows a log must see that it is another one.
std::uint64_t epochOfNow() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

MapKeeper::MapKeeper(MakeMaps make_maps, const EvidenceSpacing& spacing,
                     std::unique_ptr<EvidenceJournal> journal, Priors told)
    : make_maps_(std::move(make_maps)),
      spacing_(spacing),
      told_(std::move(told)),
      state_(made(told_, {})),
      journal_(std::move(journal)) {
  state_.log.continueAfter(epochOfNow());
  writeJournal([this] { journal_->begin(told_, {}); });
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
    arrived_.newest = observation.time;
    arrived_.at = std::chrono::steady_clock::now();
  }
  queued_.notify_one();
}

void MapKeeper::access(const std::function<void(const MapState&)>& read) const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  read(state_);
}

Arrivals MapKeeper::arrivals() const {
  const std::lock_guard<std::mutex> lock(queue_mutex_);
  Arrivals arrived = arrived_;
  arrived.waiting = queue_.size();
  return arrived;
}

bool MapKeeper::waitFor(double stamp, double timeout) const {
  std::unique_lock<std::mutex> lock(state_mutex_);
  return taken_.wait_for(lock, std::chrono::duration<double>(timeout),
                         [&] { return state_.stamp >= stamp; });
}

void MapKeeper::reset() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  MapState state = made(told_, {});
  state.since = forgetQueue();
  replace(std::move(state));
}

void MapKeeper::reset(MapSide side) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  const bool of_object = side == MapSide::kObject;
  const MapSide kept = of_object ? MapSide::kWorld : MapSide::kObject;
  const VoxelGrid& learnt = of_object ? state_.maps->world() : state_.maps->object();
  Priors priors = state_.priors;
  priors.of(side) = told_.of(side);
  const int room = kMostPriors - static_cast<int>(priors.of(side).size());
  for (Prior& piece : learntMatter(learnt, priors.of(kept), room)) {
    priors.of(kept).push_back(std::move(piece));
  }
  MapState state = made(priors, {});
  state.since = forgetQueue();
  replace(std::move(state));
}

void MapKeeper::know(MapSide side, const Prior& prior) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  Priors priors = state_.priors;
  std::vector<Prior>& pieces = priors.of(side);
  const bool is_known = std::any_of(pieces.begin(), pieces.end(),
                                    [&](const Prior& piece) { return areTheSame(piece, prior); });
  if (is_known) return;
  pieces.push_back(prior);
  MapState state = made(priors, state_.log.from(0));
  state.since = state_.since;
  state.whole = state_.whole;
  replace(std::move(state));
}

void MapKeeper::load(const Priors& priors, const std::vector<ContactObservation>& observations) {
  int contacts = 0;
  for (const ContactObservation& observation : observations) {
    contacts = std::max(contacts, observation.contact_id);
  }
  MapState loaded = made(priors, observations);
  const std::lock_guard<std::mutex> lock(state_mutex_);
  loaded.since = forgetQueue();
  loaded.whole = observations.empty();
  numbering_.continueAfter(contacts);
  replace(std::move(loaded));
}

MapState MapKeeper::made(const Priors& priors,
                         const std::vector<ContactObservation>& observations) const {
  MapState state{make_maps_(priors), priors, EvidenceLog(spacing_), {}};
  state.first_revision = state.maps->revision();  // what is known beforehand is no change
  try {
    for (const ContactObservation& observation : observations) learn(observation, &state);
  } catch (const std::out_of_range& error) {
    throw InputError(std::string("an observation lies outside of the maps (") + error.what() +
                     "); use larger voxels");
  }
  return state;
}

void MapKeeper::replace(MapState state) {
  state.log.continueAfter(state_.log.epoch());
  state.earlier = revisionOf(state_) + 1;
  state.stamp = state_.stamp;
  state_ = std::move(state);
  writeJournal([this] { journal_->begin(state_.priors, state_.log.from(0)); });
}

// Time of the newest observation up to now [s].
double MapKeeper::forgetQueue() {
  const std::lock_guard<std::mutex> lock(queue_mutex_);
  queue_.clear();
  ++forgotten_;
  return arrived_.at ? arrived_.newest : state_.stamp;
}

KeeperProblems MapKeeper::takeProblems() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return std::exchange(problems_, {});
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
    const int forgotten = forgotten_;
    lock.unlock();
    take(observation, forgotten);
    lock.lock();
  }
}

// What left the queue before that was forgotten is forgotten with it.
void MapKeeper::take(ContactObservation observation, int forgotten) {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    observation.contact_id = numbering_.numberOf(observation.contact_id);
    if (forgotten == forgotten_) takeIn(observation);
    state_.stamp = observation.time;
  }
  taken_.notify_all();
}

void MapKeeper::takeIn(const ContactObservation& observation) {
  try {
    if (!learn(observation, &state_)) return;
  } catch (const std::out_of_range& error) {
    problems_.left_out = std::string("observation left out: it lies outside of the maps (") +
                         error.what() + "); check tf, or use larger voxels";
    return;
  }
  writeJournal([&] { journal_->observe(observation); });
}

void MapKeeper::writeJournal(const std::function<void()>& write) {
  if (!journal_) return;
  try {
    write();
  } catch (const std::runtime_error& error) {
    problems_.journal_end = std::string(error.what()) + "; the journal ends here";
    journal_.reset();
  }
}

}  // namespace smore
