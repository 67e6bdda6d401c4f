// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "smore/mapping/evidence_at_unit.h"
#include "smore/mapping/marginal_map.h"
#include "smore/mapping/twin_map.h"
#include "smore/mapping/worlds.h"

namespace smore {

/// A pose of the object in the map frame, and when it was there [s].
struct StampedPose {
  double time = 0.0;
  Pose T_map_object = Pose::Identity();
};

/// Poses are kept to this accuracy [m], [rad]: a quarter of the smallest unit of length, and a turn
/// that moves what touches less. A choice: a UR5e repeats a pose to a sixteenth of it.
constexpr FreeSpaceParameters kPoseAccuracy = {0.0005, 0.005};

/// A belief that keeps all its evidence: where on each line each contact was, inferred jointly over
/// all contacts and all free poses, as 64 equally likely worlds. Both maps are their marginals.
///
/// The belief knows no size: its worlds have units of length, up to three different ones, as likely
/// as the contacts say (unitProbabilities, probabilitiesByEvidence); all that is assumed of matter
/// is a multiple of them. Where all that is observed is scaled alike, so are the worlds.
///
/// The same set of observations gives the same worlds, to the last bit, in any order, as long as no
/// contacts are merged, and much the same at any rate of free samples that is fine against the
/// cells of FreeSpaceParameters.
///
/// Observations are taken at once, but for a contact after which some are merged: that infers. What
/// follows from them is inferred when it is first asked for, or by `update`. Threads may ask at the
/// same time, but not while one observes.
class JointBelief : public TwinMap {
 public:
  explicit JointBelief(const JointBeliefParameters& parameters);

  /// An observation at a pose that is not finite is left out. std::out_of_range, and nothing else
  /// has changed, where the pose is out of the range of voxel keys.
  void observe(const ContactObservation& observation) override;
  /// Both maps: valid until the next observation. See worlds().
  const VoxelGrid& world() const override { return marginals_.of(worlds(), MapSide::kWorld); }
  const VoxelGrid& object() const override { return marginals_.of(worlds(), MapSide::kObject); }
  std::uint64_t revision() const override { return revision_; }
  void update() const override { worlds(); }

  /// Takes what is known of one map beforehand as evidence like others; the same twice counts once.
  /// InputError for more than kMostPriors pieces.
  void know(MapSide side, const Prior& prior);

  /// What the evidence says by now. The first who asks after an observation waits for the inference
  /// (Worlds::inference_s), others at the same time for him.
  std::shared_ptr<const Worlds> worlds() const;

  /// In each world, where the object was touched by a contact that was observed at this pose with
  /// this line [in the object frame; in planar motion in its plane]; nothing where that world holds
  /// the contact to be false. Empty for a contact that takes no part.
  std::vector<std::optional<Vec3>> placesOf(const Pose& T_world_object,
                                            const LineOfAction& line) const;

  /// Draws the worlds from the same evidence with other random numbers when they are next asked
  /// for.
  void drawAnew(std::uint64_t seed);

  /// As MapFrame::toMap.
  Pose toMap(const Pose& T_world_object) const { return frame_.toMap(T_world_object); }

  /// Contacts observed so far, those that were merged included.
  std::size_t contactCount() const { return levers_.size(); }
  const JointBeliefParameters& parameters() const { return parameters_; }

 private:
  void change();
  void addFree(const Pose& T_world_object);
  void noteContact(const ContactObservation& observation);
  bool addContact(const Pose& T_world_object, const LineOfAction& line);
  void mergeContacts();
  /// What is drawn at each unit that an inference asks for. What is held may be longer than the
  /// unit of matter tells: its reach is that of the smallest unit that the levers tell, at least.
  struct DrawnByUnit {
    int held = 0;
    std::map<int, DrawnEvidence> at;
  };
  const DrawnEvidence& drawnAt(int index, DrawnByUnit* drawn) const;
  std::array<int, kUnits> worldsByUnit(DrawnByUnit* drawn) const;
  EvidenceAtUnit& atUnit(int index, const DrawnByUnit& drawn) const;
  Worlds infer() const;
  void forgetOtherUnits(const DrawnByUnit& drawn) const;
  using UnitOf = double (EvidenceAtUnit::*)() const;
  double meanUnit(UnitOf unit, const std::array<int, kUnits>& counts,
                  const DrawnByUnit& drawn) const;
  std::optional<ContactHypotheses> widestPlacesOf(const Pose& T_world_object,
                                                  const LineOfAction& line) const;
  SampledWorlds sampledWorlds(const std::array<int, kUnits>& counts, DrawnByUnit* drawn,
                              TouchedPlaces* touched) const;
  std::vector<Pose> touchedPoses() const;
  WorldsAtUnit worldsAt(const EvidenceAtUnit& evidence, const ExplainedEvidence& explained,
                        const std::vector<int>& members) const;

  JointBeliefParameters parameters_;
  MapFrame frame_;
  std::uint64_t revision_ = 0;
  FreeCells free_;  ///< to the accuracy with which poses are kept
  Path trail_;      ///< a pose of each of these cells, in the order in which they were entered
  std::map<std::uint64_t, ObservedContact> contacts_;  ///< by their ids, those merged left out
  std::map<std::uint64_t, LeverOfContact> levers_;     ///< of all contacts, by their ids
  KnownPieces known_;                                  ///< beforehand, by their ids
  /// By contact_id, the first pose of each contact whose line says nothing or has not come yet;
  /// nothing for the others.
  std::map<int, std::optional<StampedPose>> poses_without_line_;

  /// By the indices of the units of matter and of what is held, those that were asked for last.
  mutable std::map<std::pair<int, int>, EvidenceAtUnit> at_unit_;
  std::unique_ptr<std::mutex> inferring_ = std::make_unique<std::mutex>();
  mutable std::shared_ptr<const Worlds> worlds_;  ///< null while nobody has asked
  mutable MarginalMaps marginals_{parameters_.voxel_size};
};

}  // namespace smore
