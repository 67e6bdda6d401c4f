// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/free_space_evidence.h"

#include <cmath>

#include "smore/mapping/counter_random.h"

namespace smore {
namespace {

// Where slots without a place are put: farther away than any two things that are compared.
const Eigen::Vector3f kNowhere(1e4F, 1e4F, 1e4F);

std::uint64_t cellOf(const Pose& pose, const FreeSpaceParameters& parameters) {
  const Eigen::AngleAxisd turn(pose.linear());
  const Vec3 rotation = turn.angle() * turn.axis();
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    hash = mixBits(hash, std::llround(pose.translation()[axis] / parameters.position_cell));
    hash = mixBits(hash, std::llround(rotation[axis] / parameters.angle_cell));
  }
  return hash;
}

void appendPlaces(const PointArray& points, int count, std::vector<Eigen::Vector3f>* places) {
  for (int i = 0; i < kCandidates; ++i) places->push_back(i < count ? points.at(i) : kNowhere);
}

bool isPlace(const Eigen::Vector3f& point) { return point.x() < kNowhere.x(); }

void setBit(CandidateBits* bits, int i) { (*bits)[i / 64] |= std::uint64_t{1} << (i % 64); }

// Index of the places alone; empty slots would stretch its box.
void rebuild(const std::vector<Eigen::Vector3f>& places, PointIndex* index) {
  std::vector<Eigen::Vector3f> filled = places;
  Eigen::Vector3f last = Eigen::Vector3f::Zero();
  for (Eigen::Vector3f& place : filled) {
    if (isPlace(place))
      last = place;
    else
      place = last;
  }
  index->build(filled);
}

}  // namespace

FreeSpaceEvidence::FreeSpaceEvidence(const FreeSpaceParameters& parameters,
                                     double conflict_distance)
    : parameters_(parameters),
      object_index_(static_cast<float>(conflict_distance)),
      world_index_(static_cast<float>(conflict_distance)) {}

void FreeSpaceEvidence::mark(int object_place, int world_place) {
  if (!isPlace(object_places_[object_place]) || !isPlace(world_places_[world_place])) return;
  const int i = object_place % kCandidates;
  const int j = world_place % kCandidates;
  std::unique_ptr<ConflictTable>& table =
      tables_[object_place / kCandidates][world_place / kCandidates];
  if (!table) table = std::make_unique<ConflictTable>();
  setBit(&table->by_object[i], j);
  setBit(&table->by_world[j], i);
}

bool FreeSpaceEvidence::knows(const Pose& T_map_object) const {
  return seen_.count(cellOf(T_map_object, parameters_)) != 0;
}

bool FreeSpaceEvidence::addPose(const Pose& T_map_object) {
  if (!seen_.insert(cellOf(T_map_object, parameters_)).second) return false;
  poses_.push_back(T_map_object.cast<float>());
  const Eigen::Isometry3f& T = poses_.back();
  for (std::size_t i = 0; i < object_places_.size(); ++i) {
    if (!isPlace(object_places_[i])) continue;
    world_index_.forNear(T * object_places_[i], [&](int j) { mark(static_cast<int>(i), j); });
  }
  return true;
}

void FreeSpaceEvidence::addContact(const ContactHypotheses& contact) {
  const int first = static_cast<int>(object_places_.size());
  appendPlaces(contact.object, contact.count, &object_places_);
  appendPlaces(contact.world, contact.count, &world_places_);
  for (auto& row : tables_) row.emplace_back();
  tables_.emplace_back(tables_.size() + 1);
  rebuild(object_places_, &object_index_);
  rebuild(world_places_, &world_index_);
  for (const Eigen::Isometry3f& T : poses_) {
    const Eigen::Isometry3f T_object_map = T.inverse();
    for (int i = first; i < first + contact.count; ++i) {
      world_index_.forNear(T * object_places_[i], [&](int j) { mark(i, j); });
      object_index_.forNear(T_object_map * world_places_[i], [&](int j) { mark(j, i); });
    }
  }
}

void FreeSpaceEvidence::clear() {
  seen_.clear();
  poses_.clear();
  object_places_.clear();
  world_places_.clear();
  tables_.clear();
  object_index_.build({});
  world_index_.build({});
}

}  // namespace smore
