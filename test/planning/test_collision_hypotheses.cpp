// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/planning/collision_hypotheses.h"

namespace smore {
namespace {

constexpr double kVoxel = 0.01;
constexpr double kCell = 0.02;

ContactObservation observationAt(const Pose& pose, ContactState state, int id = 0) {
  ContactObservation observation;
  observation.state = state;
  observation.T_world_object = pose;
  observation.contact_id = id;
  return observation;
}

Pose at(double x, double y = 0.0) { return makePose(Vec3(x, y, 0)); }

/// A block of matter whose voxels run from 0 to these numbers, as wide as ten of them each way.
std::vector<Prior> blockOf(std::int16_t x, std::int16_t y, std::int16_t z) {
  VoxelGrid known(kVoxel);
  for (std::int16_t i = 0; i < x; ++i) {
    for (std::int16_t j = 0; j < y; ++j) {
      for (std::int16_t k = 0; k < z; ++k) known.set({i, j, k}, 1.0F);
    }
  }
  known.set({x, 0, 0}, 0.0F);  // known to be free
  return {{known, 0.9}};
}

/// The block moves along x from 0 to `x` in millimetres, at the height `y`.
void moveFreely(double x, double y, CollisionHypotheses* belief) {
  for (double way = 0.0; way <= x; way += 0.001) {
    belief->observe(observationAt(at(way, y), ContactState::kFree));
  }
}

void touch(double x, double y, int id, CollisionHypotheses* belief) {
  moveFreely(x, y, belief);
  belief->observe(observationAt(at(x, y), ContactState::kContact, id));
}

TEST(CollisionHypotheses, nothingIsSuspectedBeforeTheFirstContact) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  EXPECT_EQ(belief.cellSize(), kCell);
  moveFreely(0.5, 0.0, &belief);
  EXPECT_EQ(belief.success({at(0), at(1)}), 1.0);
  EXPECT_TRUE(belief.sizes().empty());
}

// The block is five cells high and goes on for two cells beyond the contact.
TEST(CollisionHypotheses, aContactIsSomewhereInWhatWouldHaveBeenEntered) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  touch(0.2, 0.005, 1, &belief);
  ASSERT_EQ(belief.sizes().size(), 1u);
  EXPECT_NEAR(belief.sizes()[0], 2 * 5, 5) << "to the rounding of a cell in each row";
  EXPECT_GE(belief.sizes()[0], 2 * 5);
}

TEST(CollisionHypotheses, aPathPassesASetByTheShareOfItThatItLeaves) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  touch(0.2, 0.005, 1, &belief);
  EXPECT_EQ(belief.success({at(0.2, 0.005), at(0.0, 0.005)}), 1.0) << "back where it came from";
  EXPECT_NEAR(belief.success({at(0.2, 0.005), at(0.3, 0.005)}), 0.01, 1e-12) << "all of it";
  const double above = belief.success({at(0.0, 0.065), at(0.4, 0.065)});
  EXPECT_GT(above, 1.0 - 0.99 * 3.0 / 5.0) << "half of the rows";
  EXPECT_LT(above, 1.0 - 0.99 * 1.0 / 5.0);
}

TEST(CollisionHypotheses, whatIsSweptLaterLeavesTheSet) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  touch(0.2, 0.005, 1, &belief);
  const int before = belief.sizes()[0];
  const Path straight = {at(0.2, 0.005), at(0.3, 0.005)};
  const Path above = {at(0.2, 0.065), at(0.3, 0.065)};
  ASSERT_LT(belief.success(above), 1.0);
  moveFreely(0.4, 0.065, &belief);
  EXPECT_LT(belief.sizes()[0], before);
  EXPECT_GT(belief.sizes()[0], 0);
  EXPECT_EQ(belief.success(above), 1.0) << "it has been there";
  EXPECT_NEAR(belief.success(straight), 0.01, 1e-12) << "what is left is there";
  moveFreely(0.4, 0.005, &belief);
  EXPECT_EQ(belief.sizes()[0], 0);
  EXPECT_EQ(belief.success(straight), 1.0) << "a set that was refuted says nothing";
}

TEST(CollisionHypotheses, setsCountAsIndependent) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  touch(0.2, 0.005, 1, &belief);
  const Path above = {at(0.0, 0.065), at(0.4, 0.065)};
  const double one = belief.success(above);
  touch(0.2, 0.005, 2, &belief);
  EXPECT_EQ(belief.sizes()[0], belief.sizes()[1]);
  EXPECT_NEAR(belief.success(above), one * one, 1e-12);
}

TEST(CollisionHypotheses, aContactCountsOnceHoweverLongItLasts) {
  CollisionHypotheses belief(blockOf(10, 10, 1), true);
  touch(0.2, 0.005, 1, &belief);
  for (int i = 0; i < 10; ++i) touch(0.2, 0.005, 1, &belief);
  EXPECT_EQ(belief.sizes().size(), 1u);
}

TEST(CollisionHypotheses, inSpaceAllSidesOfTheObjectCount) {
  CollisionHypotheses belief(blockOf(10, 10, 10), false);
  for (int i = 0; i <= 200; ++i) {
    belief.observe(observationAt(makePose(Vec3(0.005, 0.005, 0.001 * i)), ContactState::kFree));
  }
  belief.observe(observationAt(makePose(Vec3(0.005, 0.005, 0.2)), ContactState::kContact, 1));
  ASSERT_EQ(belief.sizes().size(), 1u);
  EXPECT_GE(belief.sizes()[0], 2 * 5 * 5);
  EXPECT_LE(belief.sizes()[0], 3 * 6 * 6);
}

TEST(CollisionHypotheses, needsToBeToldOfMatter) {
  VoxelGrid nothing(kVoxel);
  nothing.set({0, 0, 0}, 0.0F);
  EXPECT_THROW(CollisionHypotheses({}, true), std::invalid_argument);
  EXPECT_THROW(CollisionHypotheses({{nothing, 0.9}}, true), std::invalid_argument);
}

}  // namespace
}  // namespace smore
