// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/free_space_evidence.h"

#include "smore/common/parallel_for.h"

namespace smore {
namespace {

// Places on the object are looked up a little farther away than balls touch: by the inverse of a
// pose, whose rounding must not decide.
constexpr float kLookUp = 1.01F;

void setBit(CandidateBits* bits, int i) { (*bits)[i / 64] |= std::uint64_t{1} << (i % 64); }

}  // namespace

FreeSpaceEvidence::FreeSpaceEvidence(const FreeSpaceParameters& parameters,
                                     double conflict_distance)
    : cells_(parameters),
      distance_(static_cast<float>(conflict_distance)),
      object_index_(kLookUp * distance_),
      world_index_(distance_) {}

bool FreeSpaceEvidence::overlap(const Eigen::Isometry3f& T_map_object, int object_place,
                                int world_place) const {
  const Eigen::Vector3f in_map = T_map_object * object_places_[object_place];
  return (world_places_[world_place] - in_map).squaredNorm() < distance_ * distance_;
}

void FreeSpaceEvidence::mark(int object_place, int world_place) {
  const int on_object = contact_of_[object_place];
  const int in_world = contact_of_[world_place];
  const int i = object_place - first_place_[on_object];
  const int j = world_place - first_place_[in_world];
  std::unique_ptr<ConflictTable>& table = tables_[on_object][in_world];
  if (!table) table = std::make_unique<ConflictTable>();
  setBit(&table->by_object[i], j);
  setBit(&table->by_world[j], i);
}

bool FreeSpaceEvidence::addPose(const Pose& T_map_object) {
  if (!cells_.add(T_map_object)) return false;
  poses_.push_back(cells_.centerOf(T_map_object).cast<float>());
  markOnObject(poses_.back(), 0, static_cast<int>(object_places_.size()));
  return true;
}

void FreeSpaceEvidence::markOnObject(const Eigen::Isometry3f& T_map_object, int first, int end) {
  for (int i = first; i < end; ++i) {
    world_index_.forNear(T_map_object * object_places_[i], [&](int j) { mark(i, j); });
  }
}

int FreeSpaceEvidence::endOf(int contact) const {
  const bool is_last = contact + 1 == static_cast<int>(first_place_.size());
  return is_last ? static_cast<int>(contact_of_.size()) : first_place_[contact + 1];
}

// The places of different contacts on the object write into different tables.
void FreeSpaceEvidence::addPoses(const std::vector<Pose>& T_map_object) {
  const std::size_t known = poses_.size();
  for (const Pose& pose : T_map_object) {
    if (cells_.add(pose)) poses_.push_back(cells_.centerOf(pose).cast<float>());
  }
  parallelFor(first_place_.size(), [&](std::size_t contact) {
    const int end = endOf(static_cast<int>(contact));
    for (std::size_t i = known; i < poses_.size(); ++i) {
      markOnObject(poses_[i], first_place_[contact], end);
    }
  });
}

void FreeSpaceEvidence::insertContact(int contact, const ContactHypotheses& places) {
  const bool is_last = contact == static_cast<int>(first_place_.size());
  const int first = is_last ? static_cast<int>(contact_of_.size()) : first_place_[contact];
  std::vector<Eigen::Vector3f> on_object;
  std::vector<Eigen::Vector3f> in_world;
  for (int i = 0; i < places.count; ++i) {
    on_object.push_back(places.object.at(i));
    in_world.push_back(places.world.at(i));
  }
  object_places_.insert(object_places_.begin() + first, on_object.begin(), on_object.end());
  world_places_.insert(world_places_.begin() + first, in_world.begin(), in_world.end());
  for (std::size_t i = first; i < contact_of_.size(); ++i) ++contact_of_[i];
  contact_of_.insert(contact_of_.begin() + first, places.count, contact);
  for (std::size_t k = contact; k < first_place_.size(); ++k) first_place_[k] += places.count;
  first_place_.insert(first_place_.begin() + contact, first);
  for (auto& row : tables_) row.emplace(row.begin() + contact);
  tables_.emplace(tables_.begin() + contact, tables_.size() + 1);
  object_index_.build(object_places_);
  world_index_.build(world_places_);
  markContact(first, first + places.count);
}

// The places of one contact on the object with all in the world; its places in the world with those
// on the object of all others. The two write into different tables.
void FreeSpaceEvidence::markContact(int first, int end) {
  const auto mark_in_world = [&](const Eigen::Isometry3f& T) {
    const Eigen::Isometry3f T_object_map = T.inverse();
    for (int j = first; j < end; ++j) {
      object_index_.forNear(T_object_map * world_places_[j], [&](int i) {
        if ((i < first || i >= end) && overlap(T, i, j)) mark(i, j);
      });
    }
  };
  parallelFor(2, [&](std::size_t role) {
    for (const Eigen::Isometry3f& T : poses_) {
      role == 0 ? markOnObject(T, first, end) : mark_in_world(T);
    }
  });
}

void FreeSpaceEvidence::removeContact(int contact) {
  const int first = first_place_[contact];
  const int end = endOf(contact);
  object_places_.erase(object_places_.begin() + first, object_places_.begin() + end);
  world_places_.erase(world_places_.begin() + first, world_places_.begin() + end);
  contact_of_.erase(contact_of_.begin() + first, contact_of_.begin() + end);
  for (std::size_t i = first; i < contact_of_.size(); ++i) --contact_of_[i];
  first_place_.erase(first_place_.begin() + contact);
  for (std::size_t k = contact; k < first_place_.size(); ++k) first_place_[k] -= end - first;
  tables_.erase(tables_.begin() + contact);
  for (auto& row : tables_) row.erase(row.begin() + contact);
  object_index_.build(object_places_);
  world_index_.build(world_places_);
}

}  // namespace smore
