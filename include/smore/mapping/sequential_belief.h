// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/mapping/twin_map.h"

namespace smore {

/// Where the paper is silent, the choices of its authors' published program.
struct SequentialBeliefParameters {
  double voxel_size = 0.03;       ///< [m], positive
  double line_half_length = 1.0;  ///< the line's reach to either side of the point nearest to the
                                  ///< object frame's origin [m], positive
  double min_probability =
      0.005;  ///< values are clamped to these, so that no voxel is ever certain
  double max_probability = 0.995;
  double free_distance = 0.03;  ///< a free pose counts when it is this far from the last one that
  double free_angle = 0.1;      ///< did [m], or turned by this [rad]; positive
};

/// The paper's method: each observation updates both maps by the laws, in the order of arrival, and
/// is forgotten. A voxel first seen on a line starts at 1 / (voxels on that line).
///
/// Free poses closer than `free_distance` and `free_angle` to the last one that counted are left
/// out, so that the result does not depend on the sampling rate; it does depend on the order (the
/// paper says so). The first line of each contact counts.
class SequentialBelief : public TwinMap {
 public:
  explicit SequentialBelief(const SequentialBeliefParameters& parameters);

  void observe(const ContactObservation& observation) override;
  const VoxelGrid& world() const override { return world_; }
  const VoxelGrid& object() const override { return object_; }
  std::uint64_t revision() const override { return revision_; }

 private:
  void applyContact(const Pose& T_world_object, const LineOfAction& line_object);
  void applyFreeSpace(const Pose& T_world_object);
  float clamped(double probability) const;

  SequentialBeliefParameters parameters_;
  VoxelGrid world_;
  VoxelGrid object_;
  std::uint64_t revision_ = 0;
  std::optional<Pose> last_free_pose_;
  int last_line_contact_ = 0;
};

}  // namespace smore
