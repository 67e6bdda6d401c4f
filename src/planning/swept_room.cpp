// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/swept_room.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace smore {
namespace {

// Poses of free motions are looked at once in so many cells: two, that few cells are missed.
constexpr double kPosesPerCell = 2.0;

std::vector<MaskedPoint> matterOfObject(const SampledWorlds& worlds, float cell) {
  MaskedPoints merged(cell);
  for (const WorldsAtUnit& part : worlds.parts()) {
    const auto add = [&](const std::vector<MaskedPoint>& balls) {
      for (const MaskedPoint& ball : balls) merged.add(ball.point, ball.mask);
    };
    add(part.object());
    for (const KnownBalls& known : part.knownObject()) add(known.balls);
  }
  return merged.points();
}

}  // namespace

SweptRoom::SweptRoom(const Worlds& worlds, const RiskSpace& space, const RiskMotions& motions)
    : motions_(&motions),
      cell_(static_cast<float>(worlds.unit)),
      object_(matterOfObject(worlds.sampled, cell_)),
      planar_(space.planar()),
      room_(cell_, planar_) {
  std::optional<RiskState> last;
  for (const Path& track : worlds.tracks) {
    for (const Pose& pose : track) {
      const RiskState state = space.toState(pose);
      if (last && kPosesPerCell * motions.distance(*last, state) < cell_) continue;
      sweep(state, &room_, &swept_);
      last = state;
    }
  }
}

// Adds to `entered` the cells that are neither in `room` nor were swept before, and them to `room`.
void SweptRoom::sweep(const RiskState& state, MaskGrid* room, Counts* entered) const {
  const Eigen::Isometry3f T_map_object = state.pose();
  for (const MaskedPoint& matter : object_) {
    const Eigen::Vector3f place = T_map_object * matter.point;
    const HypothesisMask fresh = matter.mask & ~room->at(place) & ~room_.at(place);
    room->mark(place, fresh);
    for (HypothesisMask left = fresh; left != 0; left &= left - 1) {
      ++(*entered)[__builtin_ctzll(left)];
    }
  }
}

SweptRoom::Shares SweptRoom::noSurpriseAlong(const std::vector<RiskState>& path) const {
  MaskGrid room(cell_, planar_);
  Counts entered{};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double cells = motions_->distance(path[i - 1], path[i]) / cell_;
    const int steps = std::max(1, static_cast<int>(std::ceil(cells)));
    for (int k = 1; k <= steps; ++k) {
      const auto fraction = static_cast<float>(k) / static_cast<float>(steps);
      sweep(interpolate(path[i - 1], path[i], fraction), &room, &entered);
    }
  }
  Shares result;
  for (int m = 0; m < kHypotheses; ++m) {
    const double swept = std::max(1, swept_[m]);
    result[m] = swept / (swept + entered[m]);
  }
  return result;
}

}  // namespace smore
