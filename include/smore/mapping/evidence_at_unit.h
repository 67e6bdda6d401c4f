// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/mapping/belief_parameters.h"
#include "smore/mapping/believed_prior.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/map_frame.h"
#include "smore/mapping/unit_of_length.h"
#include "smore/mapping/worlds.h"

namespace smore {

/// A contact with its line, as it was observed.
struct ObservedContact {
  std::uint64_t id = 0;  ///< ContactHypotheses::id of the rest
  Pose T_world_object = Pose::Identity();
  LineOfAction line;
};

/// kHypotheses draws of where the contacts were and of what is true of what is known beforehand.
struct DrawnEvidence {
  std::vector<JointSample> samples;
  PriorEvidence prior;
};

/// kHypotheses explanations of all contacts, and what they hold to be true of what is known
/// beforehand.
struct ExplainedEvidence {
  std::vector<Explanation> explanations;
  BelievedPrior prior;
};

/// What all observations say if the units of length are certain ones.
class EvidenceAtUnit {
 public:
  /// `parameters` in units of length; `unit` and `held` as for inMetres.
  EvidenceAtUnit(const JointBeliefParameters& parameters, const MapFrame& frame, double unit,
                 double held);

  /// False where the pose was known.
  bool addFree(const Pose& T_map_object) { return free_.addPose(T_map_object); }
  /// The same for many poses: faster after the contacts than before them.
  void addFree(const std::vector<Pose>& T_map_object) { free_.addPoses(T_map_object); }

  /// A contact that was not added yet. One whose line passes too far from the object for this unit
  /// says nothing.
  void addContact(const ObservedContact& contact);
  void removeContact(std::uint64_t id);
  /// Whether a contact was added, and its line passes near enough for this unit.
  bool knows(std::uint64_t id) const;

  /// By `seed`. `known`: beforehand.
  DrawnEvidence draw(const KnownPieces& known, std::uint64_t seed) const;

  /// What the draws say of the unit, on average. Of all `contacts` those whose lines pass too far
  /// from the hand for it are false. `widest`: as in TouchLengths.
  UnitEvidence evidenceOf(const std::vector<JointSample>& samples, std::size_t contacts,
                          double widest) const;

  /// Explanations of the contacts: those of `members` are taken evenly from the draws, the others
  /// explain nothing.
  ExplainedEvidence explain(const DrawnEvidence& drawn, const std::vector<int>& members) const;

  /// Notes where the contacts were touched in world `m`, explained in this way.
  void tellPlaces(const Explanation& explanation, int m, TouchedPlaces* touched) const;

  double unit() const { return unit_; }
  double held() const { return held_; }
  /// In metres.
  const JointBeliefParameters& parameters() const { return parameters_; }
  const FreeSpaceEvidence& free() const { return free_; }
  const std::vector<ContactHypotheses>& contacts() const { return contacts_; }  ///< by their ids

 private:
  double costOf(const std::vector<JointSample>& samples, double false_contacts) const;

  double unit_;
  double held_;
  JointBeliefParameters parameters_;
  MapFrame frame_;
  FreeSpaceEvidence free_;
  std::vector<ContactHypotheses> contacts_;
};

}  // namespace smore
