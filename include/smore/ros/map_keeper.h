// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
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
  Priors priors;  ///< what is known beforehand
  EvidenceLog log;
  std::vector<LineOfAction> lines;   ///< in the object frame, in the order of their contacts
  std::uint64_t first_revision = 0;  ///< of the maps when the log began
  std::uint64_t earlier = 0;         ///< changes of the maps that these took the place of
  double stamp = 0.0;                ///< of the newest observation taken [s]; 0: none
  double since = 0.0;                ///< of the newest observation that is forgotten [s]; 0: none
  bool whole = true;                 ///< false where others than those that came are in the log
};

/// Rises whenever a map may have changed, by whatever.
inline std::uint64_t revisionOf(const MapState& state) {
  return state.earlier + state.maps->revision();
}

/// How often the maps may have changed since their log began: the same for all that learnt from it.
inline std::uint64_t changesOf(const MapState& state) {
  return state.maps->revision() - state.first_revision;
}

/// What has come to a keeper.
struct Arrivals {
  std::size_t waiting = 0;                                  ///< observations not yet in the maps
  double newest = 0.0;                                      ///< time of the last observation [s]
  std::optional<std::chrono::steady_clock::time_point> at;  ///< when that came; nothing before one
};

/// What went wrong in a keeper; empty where nothing did.
struct KeeperProblems {
  std::string left_out;     ///< why the newest observation that was left out does not fit
  std::string journal_end;  ///< why the journal is no longer written, from now on
};

/// Takes observations into a twin map in a thread of its own, so that who hands them over never
/// waits for a belief update. Nothing is dropped: the queue grows while an update runs. An
/// observation that does not fit into the maps is left out, and a journal that can no longer be
/// written ends; both are told (takeProblems) and stop nothing else.
class MapKeeper {
 public:
  /// Makes the maps of what is known beforehand, always the same of the same; InputError where they
  /// cannot use it.
  using MakeMaps = std::function<std::unique_ptr<TwinMap>(const Priors& priors)>;

  /// `journal` may be null, else it is written from now on. `told`: what is known from the start,
  /// and after each reset.
  MapKeeper(MakeMaps make_maps, const EvidenceSpacing& spacing,
            std::unique_ptr<EvidenceJournal> journal = nullptr, Priors told = {});
  /// Ends the thread; what is still queued is left out.
  ~MapKeeper();

  /// Queues an observation. Never blocks for longer than it takes to append it.
  void push(const ContactObservation& observation);

  /// Calls `read` with the state, which changes for nobody meanwhile.
  void access(const std::function<void(const MapState&)>& read) const;

  /// What has come so far, whether it is in the maps or not. Never waits for an update of these.
  Arrivals arrivals() const;

  /// Waits until every observation up to `stamp` [s] is in the maps; false if that takes longer
  /// than `timeout` of wall time [s].
  bool waitFor(double stamp, double timeout) const;

  /// Forgets maps, evidence and what is queued, but not what was told at the start; the stamp
  /// stays.
  void reset();

  /// Forgets one map so, for another object in the hand or another place. The other one goes on:
  /// what it holds to be matter is known beforehand from now on (learntMatter), beside what was
  /// known. InputError, and nothing changes, where the maps cannot use such knowledge.
  void reset(MapSide side);

  /// Takes what is known of one map as evidence beside the observations; the same twice counts
  /// once. The maps are those that had been made knowing it from the start. InputError, and nothing
  /// changes, where they cannot use it.
  void know(MapSide side, const Prior& prior);

  /// The maps of what is known here, of these observations and of what comes from now on take the
  /// place of what was. With the same maps' parameters they are those that had been made of the
  /// same. InputError, and nothing changes, where an observation does not fit into the maps, or
  /// these cannot use what is known.
  void load(const Priors& priors, const std::vector<ContactObservation>& observations);

  /// What went wrong since the last call.
  KeeperProblems takeProblems();

 private:
  void work();
  void take(ContactObservation observation, int forgotten);
  void takeIn(const ContactObservation& observation);
  MapState made(const Priors& priors, const std::vector<ContactObservation>& observations) const;
  void replace(MapState state);
  double forgetQueue();
  void writeJournal(const std::function<void()>& write);

  MakeMaps make_maps_;
  EvidenceSpacing spacing_;
  Priors told_;

  mutable std::mutex queue_mutex_;
  std::condition_variable queued_;
  std::deque<ContactObservation> queue_;
  Arrivals arrived_;  ///< but for what waits
  bool ending_ = false;
  int forgotten_ = 0;  ///< how often the queue was; written under both mutexes

  mutable std::mutex state_mutex_;
  mutable std::condition_variable taken_;
  MapState state_;
  ContactNumbering numbering_;
  std::unique_ptr<EvidenceJournal> journal_;
  KeeperProblems problems_;  ///< that nobody has taken yet

  std::thread worker_;
};

}  // namespace smore
