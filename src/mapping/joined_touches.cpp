// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joined_touches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace smore {
namespace {

// Ways that are tried for a tie. The first is straight as often as not; the point that the others
// lead over lies beside the middle by this share of the distance (one standard deviation an axis),
// and farther with each try.
constexpr int kTries = 8;
constexpr double kStraightShare = 0.5;
constexpr double kDetour = 0.25;
constexpr double kDetourGrowth = 0.5;

using Points = std::vector<Eigen::Vector3f>;

Points apart(const Points& places, float distance) {
  Points result;
  for (const Eigen::Vector3f& place : places) {
    const bool near = std::any_of(result.begin(), result.end(), [&](const Eigen::Vector3f& other) {
      return (place - other).norm() <= distance;
    });
    if (!near) result.push_back(place);
  }
  return result;
}

class Tie {
 public:
  Tie(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float distance,
      const MatterAllowed& allowed)
      : from_(from), to_(to), distance_(distance), allowed_(allowed) {}

  /// The points of a way that is allowed; none where none of the tries was.
  Points draw(CounterRandom* random) const {
    for (int i = 0; i < kTries; ++i) {
      const bool straight = i == 0 && random->uniform() < kStraightShare;
      const double detour = straight ? 0.0 : kDetour * (1.0 + kDetourGrowth * i);
      if (const auto way = over(besideMiddle(detour, random))) return *way;
    }
    return {};
  }

 private:
  Eigen::Vector3f besideMiddle(double detour, CounterRandom* random) const {
    Eigen::Vector3f middle = 0.5F * (from_ + to_);
    const double size = detour * (to_ - from_).norm();
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] += static_cast<float>(size * random->normal());
    }
    return middle;
  }

  std::optional<Points> over(const Eigen::Vector3f& middle) const {
    Points way;
    if (!addStraight(from_, middle, &way) || !addStraight(middle, to_, &way)) return std::nullopt;
    return way;
  }

  bool addStraight(const Eigen::Vector3f& a, const Eigen::Vector3f& b, Points* way) const {
    const int count = std::max(1, static_cast<int>(std::ceil((b - a).norm() / (0.5F * distance_))));
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector3f point =
          a + (b - a) * (static_cast<float>(i) / static_cast<float>(count));
      const bool at_an_end =
          (point - from_).norm() <= distance_ || (point - to_).norm() <= distance_;
      if (!at_an_end && !allowed_(point)) return false;
      way->push_back(point);
    }
    return true;
  }

  Eigen::Vector3f from_;
  Eigen::Vector3f to_;
  float distance_;
  const MatterAllowed& allowed_;
};

// A tree over points, grown from the first by the nearest that is not in it.
class NearestTree {
 public:
  explicit NearestTree(const Points& points)
      : points_(points),
        nearest_(points.size(), 0),
        gaps_(points.size(), std::numeric_limits<float>::max()) {
    enter(0);
  }

  /// The next point and the one in the tree that it is tied to.
  std::pair<std::size_t, std::size_t> next() {
    const std::size_t point = std::min_element(gaps_.begin(), gaps_.end()) - gaps_.begin();
    const std::size_t tied_to = nearest_[point];
    enter(point);
    return {point, tied_to};
  }

 private:
  static constexpr float kInTree = std::numeric_limits<float>::infinity();

  void enter(std::size_t point) {
    gaps_[point] = kInTree;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const float gap = (points_[i] - points_[point]).norm();
      if (std::isinf(gaps_[i]) || gap >= gaps_[i]) continue;
      gaps_[i] = gap;
      nearest_[i] = point;
    }
  }

  const Points& points_;
  std::vector<std::size_t> nearest_;
  std::vector<float> gaps_;
};

}  // namespace

std::vector<Eigen::Vector3f> joinTouches(const std::vector<Eigen::Vector3f>& places, float distance,
                                         const MatterAllowed& allowed, CounterRandom* random) {
  const Points pieces = apart(places, distance);
  Points result;
  if (pieces.empty()) return result;
  NearestTree tree(pieces);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const auto [point, tied_to] = tree.next();
    const Points way = Tie(pieces[point], pieces[tied_to], distance, allowed).draw(random);
    result.insert(result.end(), way.begin(), way.end());
  }
  return result;
}

}  // namespace smore
