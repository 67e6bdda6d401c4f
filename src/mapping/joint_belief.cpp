// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_belief.h"

#include <algorithm>

#include "smore/common/elapsed_time.h"
#include "smore/mapping/contact_merging.h"
#include "smore/mapping/marginal_map.h"
#include "smore/mapping/surface_sizes.h"

namespace smore {
namespace {

// Neighbours in a track of free poses, and the largest gap that one motion leaves between samples.
constexpr double kTrackSpacing = 0.05;
constexpr double kTrackAngle = 0.15;

// Share of the contacts that is merged when there are too many: not each new one costs a merge.
constexpr int kMergedShare = 10;  // one in so many

// By time, and by their numbers where they were made at one time.
bool isBefore(const StampedPose& a, const StampedPose& b) {
  if (a.time != b.time) return a.time < b.time;
  const double* of_a = a.T_map_object.data();
  const double* of_b = b.T_map_object.data();
  return std::lexicographical_compare(of_a, of_a + 16, of_b, of_b + 16);
}

}  // namespace

JointBelief::JointBelief(const JointBeliefParameters& parameters)
    : parameters_(parameters),
      frame_(parameters.T_world_plane),
      evidence_(parameters.free_space, parameters.feature.conflictDistance()) {}

void JointBelief::observe(const ContactObservation& observation) {
  if (!isFinite(observation.T_world_object)) return;
  requireInsideOfMaps(observation.T_world_object);
  if (observation.state == ContactState::kFree) addFree(observation.T_world_object);
  if (observation.state == ContactState::kContact) noteContact(observation);
}

// All matter that a touch at the pose may speak of has a voxel.
void JointBelief::requireInsideOfMaps(const Pose& T_world_object) const {
  const double beyond = parameters_.feature.reach + parameters_.extent.world_longest +
                        3.0 * parameters_.feature.radius;
  const Vec3 corner = T_world_object.translation().cwiseAbs() + Vec3::Constant(beyond);
  (void)voxelAt(corner, parameters_.voxel_size);
}

void JointBelief::change() {
  ++revision_;
  worlds_ = nullptr;
}

void JointBelief::noteContact(const ContactObservation& observation) {
  if (observation.line && addContact(observation.T_world_object, *observation.line)) {
    poses_without_line_[observation.contact_id] = std::nullopt;
    return;
  }
  const StampedPose touched{observation.time, toMap(observation.T_world_object)};
  const auto [known, is_new] = poses_without_line_.emplace(observation.contact_id, touched);
  if (!is_new && (!known->second || !isBefore(touched, *known->second))) return;
  known->second = touched;
  change();
}

void JointBelief::addFree(const Pose& T_world_object) {
  extendTrack(T_world_object);
  if (!evidence_.addPose(toMap(T_world_object))) return;
  worlds_ = nullptr;
  if (!contacts_.empty()) ++revision_;  // without contacts the maps stay empty
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
  const auto places = contactHypotheses(frame_.T_map_world() * T_world_object, line,
                                        parameters_.feature, frame_.planar());
  if (!places) return false;
  if (!known_contacts_.insert(places->id).second) return true;
  // By their ids: sums over contacts then round alike, in whatever order they came.
  const auto after = std::upper_bound(
      contacts_.begin(), contacts_.end(), *places,
      [](const ContactHypotheses& a, const ContactHypotheses& b) { return a.id < b.id; });
  evidence_.insertContact(static_cast<int>(after - contacts_.begin()), *places);
  contacts_.insert(after, *places);
  change();
  if (static_cast<int>(contacts_.size()) > parameters_.most_contacts) mergeContacts();
  return true;
}

void JointBelief::mergeContacts() {
  std::vector<int> merged =
      coveredContacts(contacts_, worlds()->explanations, parameters_.distribution,
                      parameters_.most_contacts / kMergedShare);
  std::sort(merged.rbegin(), merged.rend());  // the last first, so that indices stay right
  for (const int contact : merged) {
    contacts_.erase(contacts_.begin() + contact);
    evidence_.removeContact(contact);
  }
  worlds_ = nullptr;
}

std::vector<std::optional<Vec3>> JointBelief::placesOf(const Pose& T_world_object,
                                                       const LineOfAction& line) const {
  const auto observed = contactHypotheses(frame_.T_map_world() * T_world_object, line,
                                          parameters_.feature, frame_.planar());
  const auto contact = std::find_if(
      contacts_.begin(), contacts_.end(),
      [&](const ContactHypotheses& known) { return observed && known.id == observed->id; });
  std::vector<std::optional<Vec3>> places;
  if (contact == contacts_.end()) return places;
  for (const Explanation& explanation : worlds()->explanations) {
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
  change();
}

void JointBelief::reset() {
  evidence_.clear();
  contacts_.clear();
  known_contacts_.clear();
  poses_without_line_.clear();
  tracks_.clear();
  ++resets_;
  change();
}

std::shared_ptr<const Worlds> JointBelief::worlds() const {
  const std::lock_guard<std::mutex> lock(*inferring_);
  if (!worlds_) worlds_ = std::make_shared<const Worlds>(infer());
  return worlds_;
}

Worlds JointBelief::infer() const {
  const auto begin = SteadyClock::now();
  const FeatureParameters& feature = parameters_.feature;
  std::vector<Explanation> explanations =
      JointDistribution(contacts_, evidence_, parameters_.distribution)
          .sample(kHypotheses, parameters_.seed);
  SampledWorlds sampled = sampledWorlds(explanations);
  VoxelGrid world = marginalMap(sampled, sampled.world(), frame_.T_map_world().inverse(),
                                feature.radius, parameters_.voxel_size);
  VoxelGrid object = marginalMap(sampled, sampled.object(), Pose::Identity(), feature.radius,
                                 parameters_.voxel_size);
  return {frame_,
          feature,
          evidence_.cells(),
          known_contacts_.size(),
          resets_,
          std::move(explanations),
          std::move(sampled),
          std::move(world),
          std::move(object),
          secondsSince(begin)};
}

SampledWorlds JointBelief::sampledWorlds(const std::vector<Explanation>& explanations) const {
  const ExtentParameters& extent = parameters_.extent;
  SampledWorlds sampled({contacts_, evidence_, explanations}, parameters_.feature, extent,
                        frame_.planar(), parameters_.seed);
  // In a plane it tells risks apart less well (docs/planning.md).
  if (!frame_.planar()) {
    sampled.weigh(HypothesisWeights(
        weightsBySize(contacts_, explanations, surfaceSizes(extent.shortest, extent.world_longest),
                      parameters_.distribution.world)));
  }
  for (const auto& [contact_id, touched] : poses_without_line_) {
    if (!touched) continue;
    sampled.setTouching(touched->T_map_object.cast<float>(), parameters_.feature.reach);
  }
  return sampled;
}

}  // namespace smore
