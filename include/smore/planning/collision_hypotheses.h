// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/contact/first_of_contact.h"
#include "smore/mapping/prior.h"
#include "smore/planning/movement_belief.h"
#include "smore/planning/movement_trail.h"

namespace smore {

/// Collision hypothesis sets (Saund and Berenson, "Motion Planning for Manipulators in Unknown
/// Environments with Contact Sensing Uncertainty", ISER 2018): the object's shape is known, and of
/// each contact that it is somewhere among the cells of the world that the object would have newly
/// entered, had it gone on. What it sweeps without a contact leaves all sets. Where on the object
/// it was touched is not used (docs/rivals.md says what is theirs).
///
/// A path that sweeps S passes a set C with probability 1 - 0.99 |C and S| / |C|, independently of
/// the other sets; the hundredth is ours, for sets that the coarseness of the cells made wrong.
class CollisionHypotheses : public ContactObserver, public MovementBelief {
 public:
  /// `object`: where the object's matter is, in its frame; free voxels and confidences are not
  /// used. Where `planar`, only what lies in the frame's x-y plane counts. Cells of the world are
  /// twice as wide as the widest of these voxels, so that a turned object leaves none out.
  /// std::invalid_argument where there is no matter.
  CollisionHypotheses(const std::vector<Prior>& object, bool planar);

  /// Free poses sweep once the object has moved by half a cell; the first observation of each
  /// contact makes a set, unless all that the object would have entered has been swept before.
  void observe(const ContactObservation& observation) override;

  double success(const Path& path) const override;

  /// Cells left in each set, in the order of the contacts; 0 where all have been swept since, which
  /// says that the cells are too coarse for this contact: it no longer counts.
  const std::vector<int>& sizes() const { return sizes_; }

  double cellSize() const { return cell_; }  ///< of the world [m]

 private:
  using Cell = std::uint64_t;

  void addMatter(const VoxelGrid& known, bool planar);
  Cell cellAt(const Vec3& point_world) const;
  void sweep(const Pose& T_world_object);
  void suppose(const Pose& T_world_object);

  double cell_ = 0.0;
  double reach_ = 0.0;                  ///< of the object's matter from its origin [m]
  std::vector<Vec3> points_;            ///< of the object's matter, in its frame
  std::vector<Vec3> surface_;           ///< those of them that are not among others on all sides
  std::optional<MovementTrail> trail_;  ///< once the reach is known
  std::optional<Pose> swept_last_;
  std::unordered_set<Cell> free_;
  std::unordered_map<Cell, std::vector<int>> suspected_;  ///< and the sets that they are in
  std::vector<int> sizes_;
  FirstOfContact contacts_;
};

}  // namespace smore
