// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/free_pose_voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

/// Flow from the left positions (as much as each weighs) over the pairs (any amount) to the right
/// ones.
class PairFlow {
 public:
  PairFlow(const std::set<PositionPair>& pairs, const std::vector<double>& left_weights,
           const std::vector<double>& right_weights)
      : left_(left_weights), right_(right_weights) {
    for (const PositionPair& pair : pairs) {
      right_of_[pair.first].push_back(pair.second);
      flow_[pair.second][pair.first] = 0.0;
    }
  }

  /// Along shortest ways: as many rounds as positions times pairs at most (Edmonds and Karp 1972).
  void maximize() {
    while (search()) augment();
  }

  /// After the maximum: the left positions that the search cannot reach, and the right ones that it
  /// can.
  PairCover cover() const {
    PairCover cover;
    for (const auto& entry : right_of_) {
      if (left_from_.count(entry.first) == 0) cover.left.insert(entry.first);
    }
    for (const auto& entry : right_from_) cover.right.insert(entry.first);
    return cover;
  }

 private:
  static constexpr std::uint32_t kSource = std::numeric_limits<std::uint32_t>::max();

  /// Breadth first along what can still flow; true when it ends at a right position with weight
  /// left.
  bool search() {
    left_from_.clear();
    right_from_.clear();
    std::queue<std::uint32_t> queue;
    const auto reach = [&](std::uint32_t left, std::uint32_t from) {
      if (left_from_.emplace(left, from).second) queue.push(left);
    };
    for (const auto& entry : right_of_) {
      if (left_[entry.first] > 0.0) reach(entry.first, kSource);
    }
    for (; !queue.empty(); queue.pop()) {
      const std::uint32_t left = queue.front();
      for (const std::uint32_t right : right_of_.at(left)) {
        if (!right_from_.emplace(right, left).second) continue;
        if (right_[right] > 0.0) {
          end_ = right;
          return true;
        }
        for (const auto& [back, flow] : flow_.at(right)) {
          if (flow > 0.0) reach(back, right);
        }
      }
    }
    return false;
  }

  /// Calls `visit` with the pairs of the way found, from its end, and whether each is used
  /// forwards.
  template <typename Visitor>
  std::uint32_t visitWay(const Visitor& visit) const {
    std::uint32_t right = end_;
    while (true) {
      const std::uint32_t left = right_from_.at(right);
      visit(left, right, true);
      right = left_from_.at(left);
      if (right == kSource) return left;
      visit(left, right, false);
    }
  }

  void augment() {
    double amount = right_[end_];
    const std::uint32_t begin =
        visitWay([&](std::uint32_t left, std::uint32_t right, bool forwards) {
          if (!forwards) amount = std::min(amount, flow_.at(right).at(left));
        });
    amount = std::min(amount, left_[begin]);
    visitWay([&](std::uint32_t left, std::uint32_t right, bool forwards) {
      flow_[right][left] += forwards ? amount : -amount;
    });
    left_[begin] -= amount;
    right_[end_] -= amount;
  }

  std::vector<double> left_;   ///< weights that have not flowed yet
  std::vector<double> right_;  ///< weights that could still take flow
  std::map<std::uint32_t, std::vector<std::uint32_t>> right_of_;   ///< pairs by left position
  std::map<std::uint32_t, std::map<std::uint32_t, double>> flow_;  ///< by right, then left
  std::map<std::uint32_t, std::uint32_t> left_from_;               ///< of the last search
  std::map<std::uint32_t, std::uint32_t> right_from_;
  std::uint32_t end_ = 0;
};

/// Whole numbers, so that equal sums compare equal; at least 1, so that nothing is freed for
/// nothing.
std::vector<double> weightsOf(const OccupiedVoxels& voxels, const VoxelGrid& grid) {
  constexpr double kScale = 1000.0;      // resolution of the log odds: 0.001
  constexpr double kCertain = 0.999999;  // keeps the log odds finite
  std::vector<double> weights;
  weights.reserve(voxels.keys.size());
  for (const VoxelKey& key : voxels.keys) {
    const double probability = std::min<double>(*grid.probability(key), kCertain);
    weights.push_back(1.0 + std::round(kScale * std::log(probability / (1.0 - probability))));
  }
  return weights;
}

OccupiedVoxels without(const OccupiedVoxels& voxels, const std::set<std::uint32_t>& positions) {
  OccupiedVoxels rest{voxels.voxel_size, {}};
  for (std::size_t i = 0; i < voxels.keys.size(); ++i) {
    if (positions.count(static_cast<std::uint32_t>(i)) == 0) rest.keys.push_back(voxels.keys[i]);
  }
  return rest;
}

}  // namespace

PairCover lightestCover(const std::set<PositionPair>& pairs,
                        const std::vector<double>& left_weights,
                        const std::vector<double>& right_weights) {
  PairFlow flow(pairs, left_weights, right_weights);
  flow.maximize();
  return flow.cover();
}

TwinVoxels voxelsGivenFree(const VoxelGrid& object, const VoxelGrid& world,
                           const Pose& T_world_object) {
  TwinVoxels voxels{occupiedVoxels(object), occupiedVoxels(world)};
  const std::set<PositionPair> pairs =
      VoxelOverlap(voxels.object, voxels.world).pairs(T_world_object);
  if (pairs.empty()) return voxels;
  const PairCover cover =
      lightestCover(pairs, weightsOf(voxels.object, object), weightsOf(voxels.world, world));
  return {without(voxels.object, cover.left), without(voxels.world, cover.right)};
}

}  // namespace smore
