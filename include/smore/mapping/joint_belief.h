// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/sampled_worlds.h"
#include "smore/mapping/twin_map.h"

namespace smore {

struct JointBeliefParameters {
  double voxel_size = 0.03;  ///< of the published maps [m], positive
  /// The plane of planar motion (its x-y plane), in which every body counts as a prism; nothing for
  /// motion in space.
  std::optional<Pose> T_world_plane;
  std::uint64_t seed = 1;
  /// Where there are more contacts, a tenth of them is merged: those that the others say as well in
  /// all worlds are left out of the inference. At least 10.
  int most_contacts = 100;
  FeatureParameters feature;
  FreeSpaceParameters free_space;
  DistributionParameters distribution;
  ExtentParameters extent;
};

/// A belief that keeps all its evidence: where on each line each contact was, inferred jointly over
/// all contacts and all free poses, as 64 worlds: equally likely ones in planar motion, in space
/// weighed by the sizes of their surfaces. Both maps are their marginals.
///
/// The same set of observations gives the same belief in any order and at any rate of free samples
/// that is fine against the cells of FreeSpaceParameters, as long as no contacts are merged. Free
/// poses take effect in the maps when they are next asked for.
class JointBelief : public TwinMap {
 public:
  explicit JointBelief(const JointBeliefParameters& parameters);

  void observe(const ContactObservation& observation) override;
  const VoxelGrid& world() const override;
  const VoxelGrid& object() const override;
  std::uint64_t revision() const override { return revision_; }
  void reset() override;

  /// The sampled worlds; in the frames of toMap.
  const SampledWorlds& worlds() const;

  /// In each world, where the object was touched by a contact that was observed at this pose with
  /// this line [in the object frame; in planar motion in its plane]; nothing where that world holds
  /// the contact to be false. Empty for a contact that takes no part.
  std::vector<std::optional<Vec3>> placesOf(const Pose& T_world_object,
                                            const LineOfAction& line) const;

  /// Draws the worlds from the same evidence with other random numbers when they are next asked
  /// for.
  void drawAnew(std::uint64_t seed);

  /// The pose of the object in the map frame: in space the world. In planar motion the frame of the
  /// plane, onto which the pose is projected: an arm is never quite in it.
  Pose toMap(const Pose& T_world_object) const;

  /// The world in the map frame.
  const Pose& mapFrame() const { return T_map_world_; }

  /// Motions that were free, in the order in which they were made [T_world_object].
  const std::vector<Path>& freeTracks() const { return tracks_; }

  const FreeSpaceEvidence& freeSpace() const { return evidence_; }

  /// Contacts observed so far, those that were merged included.
  std::size_t contactCount() const { return known_contacts_.size(); }
  const JointBeliefParameters& parameters() const { return parameters_; }

 private:
  void addFree(const Pose& T_world_object);
  void noteContact(const ContactObservation& observation);
  bool addContact(const Pose& T_world_object, const LineOfAction& line);
  void mergeContacts();
  void extendTrack(const Pose& T_world_object);
  void refresh() const;
  void publish() const;

  JointBeliefParameters parameters_;
  Pose T_map_world_ = Pose::Identity();
  std::uint64_t revision_ = 0;
  FreeSpaceEvidence evidence_;
  std::vector<ContactHypotheses> contacts_;
  std::unordered_set<std::uint64_t> known_contacts_;  ///< ids
  /// By contact_id, the pose of each contact whose line says nothing or has not come yet
  /// [T_map_object]; nothing for the others.
  std::map<int, std::optional<Pose>> poses_without_line_;
  std::vector<Path> tracks_;
  Pose last_free_ = Pose::Identity();

  // What follows from the evidence, made when it is asked for.
  mutable bool stale_ = false;
  mutable std::vector<Explanation> explanations_;
  mutable SampledWorlds worlds_;
  mutable VoxelGrid world_;
  mutable VoxelGrid object_;
};

}  // namespace smore
