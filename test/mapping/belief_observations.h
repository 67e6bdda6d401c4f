// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "smore/mapping/joint_belief.h"

namespace smore {

/// Nothing touches at `pose` at `time` [s].
inline ContactObservation freeAt(const Pose& pose, double time) {
  ContactObservation observation;
  observation.time = time;
  observation.T_world_object = pose;
  observation.state = ContactState::kFree;
  return observation;
}

/// Contact at `pose` at the point `place` of the object [object frame] with the force along
/// `direction`.
inline ContactObservation contactAt(const Pose& pose, const Vec3& place, const Vec3& direction) {
  ContactObservation observation;
  observation.T_world_object = pose;
  observation.state = ContactState::kContact;
  LineOfAction line;
  line.direction = direction.normalized();
  line.point = place - place.dot(line.direction) * line.direction;
  line.force = 5.0;
  observation.line = line;
  return observation;
}

inline JointBeliefParameters planarParameters() {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  parameters.T_world_plane = Pose::Identity();
  return parameters;
}

/// A 4 cm wide bar that reaches 0.2 m ahead of the hand, pushed against a wall at x = 0.5 at
/// several heights: lines along x with their contact at 0.2 m on the object, and free poses on the
/// way there.
inline std::vector<ContactObservation> wallObservations() {
  std::vector<ContactObservation> observations;
  for (int i = 0; i < 5; ++i) {
    const double y = 0.04 * i - 0.08;
    for (const double x : {0.0, 0.15, 0.28}) observations.push_back(freeAt(makePose({x, y, 0}), 0));
    observations.push_back(
        contactAt(makePose({0.3, y, 0}), {0.2, 0.01 * (i % 3) - 0.01, 0}, {-1, 0.01 * i, 0}));
  }
  return observations;
}

inline void observeAll(const std::vector<ContactObservation>& observations, JointBelief* belief) {
  for (const ContactObservation& observation : observations) belief->observe(observation);
}

/// Largest and mean difference over the voxels that either grid knows.
inline std::pair<double, double> difference(const VoxelGrid& a, const VoxelGrid& b) {
  double largest = 0.0;
  double sum = 0.0;
  const auto compare = [&](const VoxelGrid& from, const VoxelGrid& to) {
    for (const VoxelGrid::Voxel& voxel : from.voxels()) {
      const double other = to.probability(voxel.key).value_or(0.005F);
      const double gap = std::abs(voxel.probability - other);
      largest = std::max(largest, gap);
      sum += gap;
    }
  };
  compare(a, b);
  compare(b, a);
  return {largest, sum / std::max<std::size_t>(1, a.size() + b.size())};
}

}  // namespace smore
