// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "smore/mapping/twin_map.h"
#include "smore/ros/evidence_log.h"

namespace smore {

/// What a mapping node knows, all of one moment.
struct MapState {
  std::unique_ptr<TwinMap> maps;
  EvidenceLog log;
  std::vector<LineOfAction> lines;   ///< in the object frame, in the order of their contacts
  std::uint64_t first_revision = 0;  ///< of the maps when the log began
  double stamp = 0.0;                ///< of the newest observation taken [s]; 0: none
};

/// How often the maps changed since their log began.
inline std::uint64_t changesOf(const MapState& state) {
  return state.maps->revision() - state.first_revision;
}

/// Takes observations into a twin map in a thread of its own, so that who hands them over never
/// waits for a belief update. Nothing is dropped: the queue grows while an update runs.
class MapKeeper {
 public:
  MapKeeper(std::unique_ptr<TwinMap> maps, const EvidenceSpacing& spacing);
  /// Ends the thread; what is still queued is left out.
  ~MapKeeper();

  /// Queues an observation. Never blocks for longer than it takes to append it.
  void push(const ContactObservation& observation);

  /// Calls `read` with the state, which changes for nobody meanwhile.
  void access(const std::function<void(const MapState&)>& read) const;

  /// Waits until every observation up to `stamp` [s] is in the maps; false if that takes longer
  /// than `timeout` of wall time [s].
  bool waitFor(double stamp, double timeout) const;

  /// Forgets maps, evidence and what is queued; the stamp stays.
  void reset();

 private:
  void work();
  void take(const ContactObservation& observation);

  mutable std::mutex queue_mutex_;
  std::condition_variable queued_;
  std::deque<ContactObservation> queue_;
  bool ending_ = false;

  mutable std::mutex state_mutex_;
  mutable std::condition_variable taken_;
  MapState state_;

  std::thread worker_;
};

}  // namespace smore
