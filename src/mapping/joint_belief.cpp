// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_belief.h"

#include <algorithm>
#include <cmath>

#include "smore/mapping/contact_merging.h"
#include "smore/mapping/surface_sizes.h"

namespace smore {
namespace {

// Neighbours in a track of free poses, and the largest gap that one motion leaves between samples.
constexpr double kTrackSpacing = 0.05;
constexpr double kTrackAngle = 0.15;

// Probabilities stay off 0 and 1 by less than what one of the 64 worlds counts.
constexpr double kLeastProbability = 0.005;

// Share of the contacts that is merged when there are too many: not each new one costs a merge.
constexpr int kMergedShare = 10;  // one in so many

// The masks of voxels, beside the grid that will hold their shares.
class MaskedVoxels {
 public:
  explicit MaskedVoxels(VoxelGrid* grid) : grid_(grid) { grid_->clear(); }

  void add(const VoxelKey& key, HypothesisMask mask) {
    const auto known = grid_->find(key);
    const std::size_t position = known ? *known : grid_->set(key, 0.0F);
    if (!known) masks_.push_back(0);
    masks_[position] |= mask;
  }

  // The voxel that holds the ball's centre, and each whose own centre the ball holds.
  void addBall(const Vec3& center, double radius, HypothesisMask mask) {
    const double size = grid_->voxelSize();
    const VoxelKey key = voxelAt(center, size);
    add(key, mask);
    const VoxelKey low = voxelAt(center - Vec3::Constant(radius), size);
    const VoxelKey high = voxelAt(center + Vec3::Constant(radius), size);
    VoxelKey near;
    for (near.z = low.z; near.z <= high.z; ++near.z) {
      for (near.y = low.y; near.y <= high.y; ++near.y) {
        for (near.x = low.x; near.x <= high.x; ++near.x) {
          if ((voxelCenter(near, size) - center).norm() <= radius) add(near, mask);
        }
      }
    }
  }

  void store(const SampledWorlds& worlds) {
    for (std::size_t i = 0; i < masks_.size(); ++i) {
      const double share =
          std::clamp(worlds.shareOf(masks_[i]), kLeastProbability, 1.0 - kLeastProbability);
      grid_->setAt(i, static_cast<float>(share));
    }
  }

 private:
  VoxelGrid* grid_;
  std::vector<HypothesisMask> masks_;
};

// One side of the worlds.
void voxelize(const SampledWorlds& worlds, const std::vector<MaskedPoint>& points,
              const Pose& T_grid_map, double radius, VoxelGrid* grid) {
  MaskedVoxels voxels(grid);
  for (const MaskedPoint& ball : points) {
    voxels.addBall(T_grid_map * ball.point.cast<double>(), radius, ball.mask);
  }
  voxels.store(worlds);
}

}  // namespace

JointBelief::JointBelief(const JointBeliefParameters& parameters)
    : parameters_(parameters),
      evidence_(parameters.free_space, parameters.feature.conflictDistance()),
      world_(parameters.voxel_size),
      object_(parameters.voxel_size) {
  if (parameters.T_world_plane) T_map_world_ = parameters.T_world_plane->inverse();
}

Pose JointBelief::toMap(const Pose& T_world_object) const {
  const Pose T_map_object = T_map_world_ * T_world_object;
  return parameters_.T_world_plane ? projectedToPlane(T_map_object) : T_map_object;
}

void JointBelief::observe(const ContactObservation& observation) {
  if (observation.state == ContactState::kFree) addFree(observation.T_world_object);
  if (observation.state == ContactState::kContact) noteContact(observation);
}

void JointBelief::noteContact(const ContactObservation& observation) {
  if (observation.line && addContact(observation.T_world_object, *observation.line)) {
    poses_without_line_[observation.contact_id] = std::nullopt;
    return;
  }
  const Pose T_map_object = toMap(observation.T_world_object);
  if (!poses_without_line_.emplace(observation.contact_id, T_map_object).second) return;
  stale_ = true;
  ++revision_;
}

void JointBelief::addFree(const Pose& T_world_object) {
  extendTrack(T_world_object);
  if (!evidence_.addPose(toMap(T_world_object)) || contacts_.empty()) return;
  stale_ = true;
  ++revision_;
}

void JointBelief::extendTrack(const Pose& T_world_object) {
  const bool first = tracks_.empty();
  const bool jumped = !first && (distanceBetween(last_free_, T_world_object) > kTrackSpacing ||
                                 angleBetween(last_free_, T_world_object) > kTrackAngle);
  last_free_ = T_world_object;
  if (first || jumped) {
    tracks_.push_back({T_world_object});
    return;
  }
  const Pose& last = tracks_.back().back();
  if (distanceBetween(last, T_world_object) > kTrackSpacing ||
      angleBetween(last, T_world_object) > kTrackAngle) {
    tracks_.back().push_back(T_world_object);
  }
}

bool JointBelief::addContact(const Pose& T_world_object, const LineOfAction& line) {
  const auto places = contactHypotheses(T_map_world_ * T_world_object, line, parameters_.feature,
                                        parameters_.T_world_plane.has_value());
  if (!places) return false;
  if (!known_contacts_.insert(places->id).second) return true;
  contacts_.push_back(*places);
  evidence_.addContact(*places);
  stale_ = true;
  ++revision_;
  if (static_cast<int>(contacts_.size()) > parameters_.most_contacts) mergeContacts();
  return true;
}

void JointBelief::mergeContacts() {
  refresh();
  std::vector<int> merged = coveredContacts(contacts_, explanations_, parameters_.distribution,
                                            parameters_.most_contacts / kMergedShare);
  std::sort(merged.rbegin(), merged.rend());  // the last first, so that indices stay right
  for (const int contact : merged) {
    contacts_.erase(contacts_.begin() + contact);
    evidence_.removeContact(contact);
  }
  stale_ = true;
}

const VoxelGrid& JointBelief::world() const {
  refresh();
  return world_;
}

const VoxelGrid& JointBelief::object() const {
  refresh();
  return object_;
}

const SampledWorlds& JointBelief::worlds() const {
  refresh();
  return worlds_;
}

std::vector<std::optional<Vec3>> JointBelief::placesOf(const Pose& T_world_object,
                                                       const LineOfAction& line) const {
  refresh();
  const auto observed = contactHypotheses(T_map_world_ * T_world_object, line, parameters_.feature,
                                          parameters_.T_world_plane.has_value());
  const auto contact = std::find_if(
      contacts_.begin(), contacts_.end(),
      [&](const ContactHypotheses& known) { return observed && known.id == observed->id; });
  std::vector<std::optional<Vec3>> places;
  if (contact == contacts_.end()) return places;
  for (const Explanation& explanation : explanations_) {
    const int i = explanation[contact - contacts_.begin()];
    places.emplace_back();
    if (i == kFalseContact) continue;
    const Eigen::Vector3f depth =
        static_cast<float>(parameters_.feature.radius) * contact->object_normal.at(i);
    places.back() = (contact->object.at(i) - depth).cast<double>();
  }
  return places;
}

void JointBelief::drawAnew(std::uint64_t seed) {
  parameters_.seed = seed;
  stale_ = true;
  ++revision_;
}

void JointBelief::reset() {
  evidence_.clear();
  contacts_.clear();
  known_contacts_.clear();
  poses_without_line_.clear();
  tracks_.clear();
  stale_ = true;
  ++revision_;
}

void JointBelief::refresh() const {
  if (!stale_) return;
  stale_ = false;
  const JointDistribution distribution(contacts_, evidence_, parameters_.distribution);
  explanations_ = distribution.sample(kHypotheses, parameters_.seed);
  worlds_ =
      SampledWorlds({contacts_, evidence_, explanations_}, parameters_.feature, parameters_.extent,
                    parameters_.T_world_plane.has_value(), parameters_.seed);
  // In a plane it tells risks apart less well (docs/planning.md).
  if (!parameters_.T_world_plane) {
    const ExtentParameters& extent = parameters_.extent;
    worlds_.weigh(weightsBySize(contacts_, explanations_,
                                surfaceSizes(extent.shortest, extent.world_longest),
                                parameters_.distribution.world));
  }
  for (const auto& [contact_id, T_map_object] : poses_without_line_) {
    if (!T_map_object) continue;
    worlds_.setTouching(T_map_object->cast<float>(), parameters_.feature.reach);
  }
  publish();
}

void JointBelief::publish() const {
  const double radius = parameters_.feature.radius;
  voxelize(worlds_, worlds_.world(), T_map_world_.inverse(), radius, &world_);
  voxelize(worlds_, worlds_.object(), Pose::Identity(), radius, &object_);
}

}  // namespace smore
