// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "smore/contact/contact_numbering.h"
#include "smore/mapping/twin_map.h"
#include "smore/retrieval/evidence_journal.h"
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
/// waits for a belief update. Nothing is dropped: the queue grows while an update runs. An
/// observation that does not fit into the maps is left out, and a journal that can no longer be
/// written ends; both are told (takeProblem) and stop nothing else.
class MapKeeper {
 public:
  using MakeMaps = std::function<std::unique_ptr<TwinMap>()>;

  /// `make_maps` makes empty maps, always the same; `journal` may be null, else it is written from
  /// now on.
  MapKeeper(MakeMaps make_maps, const EvidenceSpacing& spacing,
            std::unique_ptr<EvidenceJournal> journal = nullptr);
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

  /// The maps of these observations and of what comes from now on take the place of what was. With
  /// the same maps' parameters they are those that had been made of the same observations.
  /// InputError, and nothing changes, where one does not fit into the maps.
  void load(const std::vector<ContactObservation>& observations);

  /// What went wrong since the last call; nothing where all is well.
  std::optional<std::string> takeProblem();

 private:
  void work();
  void take(ContactObservation observation);
  void takeIn(const ContactObservation& observation);
  void writeJournal(const std::function<void()>& write);

  MakeMaps make_maps_;
  EvidenceSpacing spacing_;

  mutable std::mutex queue_mutex_;
  std::condition_variable queued_;
  std::deque<ContactObservation> queue_;
  bool ending_ = false;

  mutable std::mutex state_mutex_;
  mutable std::condition_variable taken_;
  MapState state_;
  ContactNumbering numbering_;
  std::unique_ptr<EvidenceJournal> journal_;
  std::optional<std::string> problem_;

  std::thread worker_;
};

}  // namespace smore
