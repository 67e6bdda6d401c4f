// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_cells.h"
#include "smore/mapping/point_index.h"

namespace smore {

/// One bit for each place of a line.
using CandidateBits = std::array<std::uint64_t, kCandidates / 64>;

/// Which places of two contacts contradict each other: the object's ball of the one and the world's
/// ball of the other overlapped at a pose that was free: docs/belief.md (B3).
struct ConflictTable {
  std::array<CandidateBits, kCandidates> by_object{};  ///< for a place on the object: world places
  std::array<CandidateBits, kCandidates> by_world{};   ///< for a place in the world: object places

  /// Whether the place `i` on the object contradicts the place `j` in the world.
  bool at(int i, int j) const { return ((by_object[i][j / 64] >> (j % 64)) & 1U) != 0; }
};

/// Everything that contact-free poses say about the places of all contacts. Each cell of
/// poses counts once, as its centre, and each contradiction is one bit, however many poses show it.
/// So neither the order nor the rate of the poses matters.
class FreeSpaceEvidence {
 public:
  FreeSpaceEvidence(const FreeSpaceParameters& parameters, double conflict_distance);

  /// Nothing touched at this pose of the object in the map frame. False where that was known.
  bool addPose(const Pose& T_map_object);

  /// The same for many poses, on all processor cores.
  void addPoses(const std::vector<Pose>& T_map_object);

  /// A contact's places, with all that the known free poses say about them; `contact` is its index
  /// from now on, at most the number of contacts: those from there on move down by one.
  void insertContact(int contact, const ContactHypotheses& places);

  /// Forgets a contact; those after it move up by one.
  void removeContact(int contact);

  /// All poses that were free.
  const FreeCells& cells() const { return cells_; }

  /// The centres of their cells [T_map_object].
  const std::vector<Eigen::Isometry3f>& poses() const { return poses_; }

  /// Conflicts between places of contact `on_object` on the object and of contact `in_world` in the
  /// world or null where there are none.
  const ConflictTable* conflicts(int on_object, int in_world) const {
    return tables_[on_object][in_world].get();
  }

 private:
  /// Whether two balls overlap at a pose: decided in one way, whichever came first.
  bool overlap(const Eigen::Isometry3f& T_map_object, int object_place, int world_place) const;
  void mark(int object_place, int world_place);
  void markContact(int first, int end);
  /// The places on the object from `first` to before `end` at a pose, with all in the world.
  void markOnObject(const Eigen::Isometry3f& T_map_object, int first, int end);
  /// Behind the last place of a contact.
  int endOf(int contact) const;

  FreeCells cells_;
  float distance_;  ///< of the centres of two balls at which they touch [m]
  std::vector<Eigen::Isometry3f> poses_;
  // The places of all contacts, one contact after the other.
  std::vector<Eigen::Vector3f> object_places_;
  std::vector<Eigen::Vector3f> world_places_;
  std::vector<int> contact_of_;   ///< for each place
  std::vector<int> first_place_;  ///< for each contact
  PointIndex object_index_;
  PointIndex world_index_;
  std::vector<std::vector<std::unique_ptr<ConflictTable>>> tables_;  ///< [on_object][in_world]
};

}  // namespace smore
