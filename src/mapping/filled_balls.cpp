// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/filled_balls.h"

#include <array>
#include <cstddef>
#include <deque>
#include <utility>

#include "smore/common/parallel_for.h"

namespace smore {
namespace {

using Cell = MaskBricks::Cell;

Eigen::Vector3f placeOf(const Cell& cell, float step) {
  return step * Eigen::Array3i::Map(cell.data()).cast<float>().matrix();
}

// The lowest of the eight points of the lattice around a place.
Cell cellBelow(const Eigen::Vector3f& place, float step) {
  const Eigen::Array3i below = (place / step).array().floor().cast<int>();
  return {below.x(), below.y(), below.z()};
}

std::array<Cell, 6> neighboursOf(const Cell& cell) {
  const auto [x, y, z] = cell;
  return {
      {{x - 1, y, z}, {x + 1, y, z}, {x, y - 1, z}, {x, y + 1, z}, {x, y, z - 1}, {x, y, z + 1}}};
}

HypothesisMask maskAt(const MaskBricks& masks, const Cell& cell) {
  return masks.at(cell[0], cell[1], cell[2]);
}

void mark(const Cell& cell, HypothesisMask mask, MaskBricks* masks) {
  masks->mark(cell[0], cell[1], cell[2], mask);
}

// Calls visit(cell, mask) for each marked cell of the brick from `lowest` on.
template <typename Visit>
void forMarked(const MaskBricks& masks, const Cell& lowest, const Visit& visit) {
  for (int z = 0; z < masks.layers(); ++z) {
    for (int y = 0; y < MaskBricks::kSide; ++y) {
      for (int x = 0; x < MaskBricks::kSide; ++x) {
        const Cell cell{lowest[0] + x, lowest[1] + y, lowest[2] + z};
        const HypothesisMask mask = maskAt(masks, cell);
        if (mask != 0) visit(cell, mask);
      }
    }
  }
}

void markWithin(const TouchedBall& ball, float step, MaskBricks* within) {
  const Cell low = cellBelow(ball.center.array() - ball.radius, step);
  const Cell high = cellBelow(ball.center.array() + ball.radius, step);
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int x = low[0]; x <= high[0]; ++x) {
        const float distance = (placeOf({x, y, z}, step) - ball.center).norm();
        if (distance <= ball.radius) within->mark(x, y, z, ball.mask);
      }
    }
  }
}

// On all processor cores.
MaskBricks allowedWithin(const MaskBricks& within, float step, const ForbiddenAt& forbidden) {
  std::vector<MaskBricks> parts(within.bricks().size());
  parallelFor(parts.size(), [&](std::size_t i) {
    forMarked(within, within.bricks()[i], [&](const Cell& cell, HypothesisMask mask) {
      mark(cell, mask & ~forbidden(placeOf(cell, step), mask), &parts[i]);
    });
  });
  MaskBricks result;
  result.add(parts);
  return result;
}

// Masks that spread from cell to cell, as far as these are open, each bit by itself.
class Flood {
 public:
  explicit Flood(const MaskBricks& open) : open_(open) {}

  void enter(const Cell& cell, HypothesisMask mask) {
    const HypothesisMask fresh = mask & maskAt(open_, cell) & ~maskAt(reached_, cell);
    if (fresh == 0) return;
    mark(cell, fresh, &reached_);
    entered_.emplace_back(cell, fresh);
  }

  // The first that were entered go on first: so bits that spread alike stay together.
  void spread() {
    while (!entered_.empty()) {
      const auto [cell, mask] = entered_.front();
      entered_.pop_front();
      for (const Cell& next : neighboursOf(cell)) enter(next, mask);
    }
  }

  const MaskBricks& reached() const { return reached_; }

 private:
  const MaskBricks& open_;
  MaskBricks reached_;
  std::deque<std::pair<Cell, HypothesisMask>> entered_;
};

// The eight points of the lattice around each place on the diameter from the touch on.
void enterBehind(const TouchedBall& ball, float step, Flood* flood) {
  const Eigen::Vector3f across = 2.0F * (ball.center - ball.touch);
  const int steps = static_cast<int>(2.0F * ball.radius / step) + 1;
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    const auto [x, y, z] = cellBelow(ball.touch + share * across, step);
    for (int corner = 0; corner < 8; ++corner) {
      flood->enter({x + corner % 2, y + corner / 2 % 2, z + corner / 4}, ball.mask);
    }
  }
}

}  // namespace

std::vector<MaskedPoint> fillBalls(const std::vector<TouchedBall>& balls, float step,
                                   const ForbiddenAt& forbidden) {
  MaskBricks within;
  for (const TouchedBall& ball : balls) markWithin(ball, step, &within);
  const MaskBricks open = allowedWithin(within, step, forbidden);
  Flood flood(open);
  for (const TouchedBall& ball : balls) enterBehind(ball, step, &flood);
  flood.spread();
  std::vector<MaskedPoint> points;
  for (const Cell& lowest : flood.reached().bricks()) {
    forMarked(flood.reached(), lowest, [&](const Cell& cell, HypothesisMask mask) {
      points.push_back({placeOf(cell, step), mask});
    });
  }
  return points;
}

}  // namespace smore
