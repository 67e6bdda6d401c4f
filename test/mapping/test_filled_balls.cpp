// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "smore/mapping/filled_balls.h"

namespace smore {
namespace {

using Cell = std::array<int, 3>;

constexpr float kStep = 0.02F;

HypothesisMask nowhere(const Eigen::Vector3f& /*point*/, HypothesisMask /*asked*/) { return 0; }

Cell cellOf(const Eigen::Vector3f& point) {
  const Eigen::Array3i cell = (point / kStep).array().round().cast<int>();
  return {cell.x(), cell.y(), cell.z()};
}

std::map<Cell, HypothesisMask> byCell(const std::vector<MaskedPoint>& points) {
  std::map<Cell, HypothesisMask> result;
  for (const MaskedPoint& point : points) {
    EXPECT_TRUE(result.emplace(cellOf(point.point), point.mask).second) << "twice the same point";
    EXPECT_NE(point.mask, 0U);
  }
  return result;
}

TouchedBall ballBehind(const Eigen::Vector3f& touch, float radius, HypothesisMask mask) {
  return {touch, touch + radius * Eigen::Vector3f::UnitX(), radius, mask};
}

// Wherever the touch and the ball lie between the points of the lattice.
TEST(FilledBalls, AreWholeWhereNothingIsForbidden) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> place(-0.1F, 0.1F);
  std::uniform_real_distribution<float> size(0.5F * kStep, 5.0F * kStep);
  std::normal_distribution<float> way(0.0F, 1.0F);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3f touch(place(random), place(random), place(random));
    const float radius = size(random);
    const Eigen::Vector3f into =
        Eigen::Vector3f(way(random), way(random), way(random)).normalized();
    const TouchedBall ball{touch, touch + radius * into, radius, 5};
    std::size_t within = 0;
    for (int n = 0; n < 31 * 31 * 31; ++n) {
      const Eigen::Vector3f point(n % 31 - 15, n / 31 % 31 - 15, n / (31 * 31) - 15);
      if ((kStep * point - ball.center).norm() <= radius) ++within;
    }
    const auto filled = fillBalls({ball}, kStep, nowhere);
    EXPECT_EQ(filled.size(), within) << i;
    for (const MaskedPoint& point : filled) EXPECT_EQ(point.mask, 5U);
  }
}

// Beyond a wall beside the touch there is no matter, even where it is not forbidden.
TEST(FilledBalls, EndWhereMatterIsForbidden) {
  const auto wall = [](const Eigen::Vector3f& point, HypothesisMask asked) -> HypothesisMask {
    return std::abs(point.y() - 2.0F * kStep) < 0.6F * kStep ? asked & 1U : 0;
  };
  const auto filled =
      byCell(fillBalls({ballBehind(Eigen::Vector3f::Zero(), 0.1F, 3)}, kStep, wall));
  bool beyond = false;
  for (const auto& [cell, mask] : filled) {
    EXPECT_EQ(mask & 1U, cell[1] < 2 ? 1U : 0U);
    beyond = beyond || cell[1] > 2;
  }
  EXPECT_TRUE(beyond) << "in the other world the wall is not there";
}

TEST(FilledBalls, HoldNothingWhereAllThatLiesStraightBehindTheTouchIsForbidden) {
  const auto along = [](const Eigen::Vector3f& point, HypothesisMask asked) -> HypothesisMask {
    return std::abs(point.y()) < 2.0F * kStep ? asked & 1U : 0;
  };
  EXPECT_TRUE(fillBalls({ballBehind({0.001F, 0.0F, 0.0F}, 0.1F, 1)}, kStep, along).empty());
}

// One world at a time, without any lattice of masks.
std::map<Cell, HypothesisMask> oneByOne(const std::vector<TouchedBall>& balls,
                                        const ForbiddenAt& forbidden) {
  std::map<Cell, HypothesisMask> result;
  for (int m = 0; m < kHypotheses; ++m) {
    const HypothesisMask bit = HypothesisMask{1} << m;
    const auto holds = [&](const Cell& cell) {
      const Eigen::Vector3f point(cell[0] * kStep, cell[1] * kStep, cell[2] * kStep);
      if (forbidden(point, bit) != 0) return false;
      return std::any_of(balls.begin(), balls.end(), [&](const TouchedBall& ball) {
        return (ball.mask & bit) != 0 && (point - ball.center).norm() <= ball.radius;
      });
    };
    std::vector<Cell> open;
    const auto enter = [&](const Cell& cell) {
      if (!holds(cell) || (result[cell] & bit) != 0) return;
      result[cell] |= bit;
      open.push_back(cell);
    };
    for (const TouchedBall& ball : balls) {
      if ((ball.mask & bit) == 0) continue;
      const Eigen::Vector3f across = 2.0F * (ball.center - ball.touch);
      const int steps = static_cast<int>(2.0F * ball.radius / kStep) + 1;
      for (int i = 0; i <= steps; ++i) {
        const Eigen::Vector3f behind = ball.touch + static_cast<float>(i) / steps * across;
        const Eigen::Array3i low = (behind / kStep).array().floor().cast<int>();
        for (int c = 0; c < 8; ++c) {
          enter({low.x() + c % 2, low.y() + c / 2 % 2, low.z() + c / 4});
        }
      }
    }
    while (!open.empty()) {
      const auto [x, y, z] = open.back();
      open.pop_back();
      for (const int way : {-1, 1}) {
        enter({x + way, y, z});
        enter({x, y + way, z});
        enter({x, y, z + way});
      }
    }
  }
  for (auto at = result.begin(); at != result.end();) {
    at = at->second == 0 ? result.erase(at) : std::next(at);
  }
  return result;
}

struct RandomBalls {
  std::vector<TouchedBall> balls;
  std::vector<TouchedBall> holes;

  explicit RandomBalls(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> place(-0.15F, 0.15F);
    std::uniform_real_distribution<float> size(0.0F, 0.12F);  // some hold no point of the lattice
    std::normal_distribution<float> way(0.0F, 1.0F);
    const auto vector = [&](auto& draw) {
      return Eigen::Vector3f(draw(random), draw(random), draw(random));
    };
    for (std::vector<TouchedBall>* each : {&balls, &holes}) {
      for (int i = 0; i < 12; ++i) {
        TouchedBall ball{vector(place), {}, size(random), random() & random()};
        ball.center = ball.touch + ball.radius * vector(way).normalized();
        each->push_back(ball);
      }
    }
  }

  HypothesisMask forbiddenAt(const Eigen::Vector3f& point, HypothesisMask asked) const {
    HypothesisMask result = 0;
    for (const TouchedBall& hole : holes) {
      if ((point - hole.center).norm() < hole.radius) result |= hole.mask;
    }
    return result & asked;
  }
};

TEST(FilledBalls, AreInEachHypothesisWhatTheyAreInItAlone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RandomBalls scene(seed);
    const auto forbidden = [&](const Eigen::Vector3f& point, HypothesisMask asked) {
      return scene.forbiddenAt(point, asked);
    };
    const auto filled = byCell(fillBalls(scene.balls, kStep, forbidden));
    EXPECT_GT(filled.size(), 100U);
    EXPECT_EQ(filled, oneByOne(scene.balls, forbidden)) << seed;
  }
}

}  // namespace
}  // namespace smore
