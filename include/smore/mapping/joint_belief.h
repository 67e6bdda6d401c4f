// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_set>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/twin_map.h"
#include "smore/mapping/worlds.h"

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

/// A pose of the object in the map frame, and when it was there [s].
struct StampedPose {
  double time = 0.0;
  Pose T_map_object = Pose::Identity();
};

/// A belief that keeps all its evidence: where on each line each contact was, inferred jointly over
/// all contacts and all free poses, as 64 worlds: equally likely ones in planar motion, in space
/// weighed by the sizes of their surfaces. Both maps are their marginals.
///
/// The same set of observations gives the same belief, to the last bit, in any order, as long as no
/// contacts are merged, and much the same at any rate of free samples that is fine against the
/// cells of FreeSpaceParameters.
///
/// Observations are taken at once; what follows from them is inferred when it is first asked for,
/// or by `update`. Threads may ask at the same time, but not while one observes.
class JointBelief : public TwinMap {
 public:
  explicit JointBelief(const JointBeliefParameters& parameters);

  /// An observation at a pose that is not finite is left out. std::out_of_range, and nothing else
  /// has changed, where matter that it may speak of is out of the range of voxel keys.
  void observe(const ContactObservation& observation) override;
  /// Both maps: valid until the next observation. See worlds().
  const VoxelGrid& world() const override { return worlds()->world; }
  const VoxelGrid& object() const override { return worlds()->object; }
  std::uint64_t revision() const override { return revision_; }
  void update() const override { worlds(); }
  void reset() override;

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
  const MapFrame& frame() const { return frame_; }

  /// Motions that were free, in the order in which they were made [T_world_object].
  const std::vector<Path>& freeTracks() const { return tracks_; }

  const FreeSpaceEvidence& freeSpace() const { return evidence_; }

  /// Contacts observed so far, those that were merged included.
  std::size_t contactCount() const { return known_contacts_.size(); }
  const JointBeliefParameters& parameters() const { return parameters_; }

 private:
  void requireInsideOfMaps(const Pose& T_world_object) const;
  void change();
  void addFree(const Pose& T_world_object);
  void noteContact(const ContactObservation& observation);
  bool addContact(const Pose& T_world_object, const LineOfAction& line);
  void mergeContacts();
  void extendTrack(const Pose& T_world_object);
  Worlds infer() const;
  SampledWorlds sampledWorlds(const std::vector<Explanation>& explanations) const;

  JointBeliefParameters parameters_;
  MapFrame frame_;
  std::uint64_t revision_ = 0;
  std::uint64_t resets_ = 0;
  FreeSpaceEvidence evidence_;
  std::vector<ContactHypotheses> contacts_;           ///< by their ids
  std::unordered_set<std::uint64_t> known_contacts_;  ///< ids
  /// By contact_id, the first pose of each contact whose line says nothing or has not come yet;
  /// nothing for the others.
  std::map<int, std::optional<StampedPose>> poses_without_line_;
  std::vector<Path> tracks_;
  Pose last_free_ = Pose::Identity();

  std::unique_ptr<std::mutex> inferring_ = std::make_unique<std::mutex>();
  mutable std::shared_ptr<const Worlds> worlds_;  ///< null while nobody has asked
};

}  // namespace smore
