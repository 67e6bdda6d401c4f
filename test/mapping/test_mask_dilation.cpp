// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "smore/mapping/mask_dilation.h"

namespace smore {
namespace {

using Cell = MaskBricks::Cell;

struct Marked {
  Cell cell;
  HypothesisMask mask;
};

struct Case {
  bool flat;
  float radius;   // [cells]
  int half_side;  // of the box that the marked cells lie in [cells]
  int count;
};

std::vector<Marked> markedCells(const Case& given) {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> anywhere(-given.half_side, given.half_side);
  std::vector<Marked> result;
  for (int i = 0; i < given.count; ++i) {
    const Cell cell{anywhere(random), anywhere(random), given.flat ? 0 : anywhere(random)};
    result.push_back({cell, HypothesisMask{1} << (i % kHypotheses) | random() % 2});
  }
  return result;
}

HypothesisMask ofAllPairs(const std::vector<Marked>& marked, const Cell& at, float radius) {
  HypothesisMask result = 0;
  for (const auto& [cell, mask] : marked) {
    int squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      squared += (cell[axis] - at[axis]) * (cell[axis] - at[axis]);
    }
    if (static_cast<float>(squared) < radius * radius) result |= mask;
  }
  return result;
}

class Dilated : public testing::TestWithParam<Case> {};

// The boxes straddle the borders of bricks and of the tiles in which the result is made.
TEST_P(Dilated, HoldsTheMasksOfAllMarkedCellsThatAreNearer) {
  const Case given = GetParam();
  const std::vector<Marked> marked = markedCells(given);
  MaskBricks bricks(given.flat);
  for (const auto& [cell, mask] : marked) bricks.mark(cell[0], cell[1], cell[2], mask);
  const MaskBricks result = dilated(bricks, given.radius);
  const CellBox box = boxAround({3, -9, given.flat ? 0 : -1}, 8, given.flat ? 1 : 8);
  MaskBox around(widened(box, given.radius, given.flat));
  for (const auto& [cell, mask] : marked) around.mark(cell, mask);
  const MaskBox in_one_box = dilated(around, given.radius, given.flat, box);
  const int side = given.half_side + static_cast<int>(given.radius) + 1;
  const int height = given.flat ? 0 : side;
  int filled = 0;
  std::size_t in_box = 0;
  for (int z = -height; z <= height; ++z) {
    for (int y = -side; y <= side; ++y) {
      for (int x = -side; x <= side; ++x) {
        const HypothesisMask expected = ofAllPairs(marked, {x, y, z}, given.radius);
        ASSERT_EQ(result.at(x, y, z), expected) << x << ' ' << y << ' ' << z;
        ASSERT_EQ(*result.maskAt(result.placeOf(x, y, z)), expected) << "in two steps";
        filled += expected != 0 ? 1 : 0;
        if (!box.contains({x, y, z})) continue;
        ASSERT_EQ(in_one_box.at({x, y, z}), expected) << "in one box";
        ++in_box;
      }
    }
  }
  EXPECT_GT(filled, given.count);
  EXPECT_EQ(in_box, box.count());
}

INSTANTIATE_TEST_SUITE_P(Cases, Dilated,
                         testing::Values(Case{false, 1.5F, 20, 40}, Case{false, 6.2F, 30, 30},
                                         Case{false, 9.5F, 12, 8}, Case{true, 3.5F, 80, 60},
                                         Case{true, 12.3F, 150, 20}));

}  // namespace
}  // namespace smore
