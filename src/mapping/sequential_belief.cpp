// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/sequential_belief.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "smore/mapping/probability_laws.h"
#include "smore/mapping/voxel_line.h"
#include "smore/mapping/voxel_pairing.h"

namespace smore {
namespace {

void requirePositive(double value, const char* name) {
  if (!(value > 0.0)) throw std::invalid_argument(std::string(name) + " must be positive");
}

// Position of the voxel, stored with the prior if it is new.
std::size_t seen(VoxelGrid* grid, const VoxelKey& key, float prior) {
  const auto position = grid->find(key);
  return position ? *position : grid->set(key, prior);
}

double valueAt(const VoxelGrid& grid, std::size_t position) {
  return grid.voxels()[position].probability;
}

// World voxels whose partner in the object map is known.
std::vector<VoxelKey> knownPairs(const VoxelGrid& world, const VoxelGrid& object,
                                 const Pose& T_object_world) {
  const double size = world.voxelSize();
  std::vector<VoxelKey> keys;
  for (const VoxelGrid::Voxel& voxel : world.voxels()) {
    const Vec3 center_object = T_object_world * voxelCenter(voxel.key, size);
    if (object.find(voxelAt(center_object, size))) keys.push_back(voxel.key);
  }
  return keys;
}

}  // namespace

SequentialBelief::SequentialBelief(const SequentialBeliefParameters& parameters)
    : parameters_(parameters), world_(parameters.voxel_size), object_(parameters.voxel_size) {
  requirePositive(parameters.line_half_length, "line_half_length");
  requirePositive(parameters.free_distance, "free_distance");
  requirePositive(parameters.free_angle, "free_angle");
}

void SequentialBelief::observe(const ContactObservation& observation) {
  const Pose& pose = observation.T_world_object;
  if (observation.line && observation.contact_id != last_line_contact_) {
    applyContact(pose, *observation.line);
    last_line_contact_ = observation.contact_id;
  }
  if (observation.state != ContactState::kFree) return;
  const bool near_last = last_free_pose_ &&
                         distanceBetween(*last_free_pose_, pose) < parameters_.free_distance &&
                         angleBetween(*last_free_pose_, pose) < parameters_.free_angle;
  if (near_last) return;
  applyFreeSpace(pose);
  last_free_pose_ = pose;
}

void SequentialBelief::applyContact(const Pose& T_world_object, const LineOfAction& line_object) {
  const LineOfAction line = transformLine(T_world_object, line_object);
  const Vec3 reach = parameters_.line_half_length * line.direction;
  const auto keys = voxelsOnSegment(line.point - reach, line.point + reach, parameters_.voxel_size);
  const auto pairs = pairVoxels(keys, T_world_object, parameters_.voxel_size);
  const float prior = clamped(1.0 / static_cast<double>(keys.size()));

  std::vector<VoxelPair> priors;
  std::vector<std::pair<std::size_t, std::size_t>> positions;
  for (const PairedVoxels& pair : pairs) {
    positions.emplace_back(seen(&world_, pair.world, prior), seen(&object_, pair.object, prior));
    priors.push_back(
        {valueAt(world_, positions.back().first), valueAt(object_, positions.back().second)});
  }
  const auto posterior = contactLaw(priors);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    world_.setAt(positions[i].first, clamped(posterior[i].p));
    object_.setAt(positions[i].second, clamped(posterior[i].q));
  }
  ++revision_;
}

void SequentialBelief::applyFreeSpace(const Pose& T_world_object) {
  const auto keys = knownPairs(world_, object_, T_world_object.inverse());
  for (const PairedVoxels& pair : pairVoxels(keys, T_world_object, parameters_.voxel_size)) {
    const std::size_t world = *world_.find(pair.world);
    const std::size_t object = *object_.find(pair.object);
    const VoxelPair posterior = freeSpaceLaw({valueAt(world_, world), valueAt(object_, object)});
    world_.setAt(world, clamped(posterior.p));
    object_.setAt(object, clamped(posterior.q));
  }
  if (!keys.empty()) ++revision_;
}

float SequentialBelief::clamped(double probability) const {
  return static_cast<float>(
      std::clamp(probability, parameters_.min_probability, parameters_.max_probability));
}

}  // namespace smore
