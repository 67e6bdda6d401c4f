// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "smore/planning/blocked_movements.h"
#include "smore/planning/movement_planner.h"
#include "voxel_oracle.h"

namespace smore {
namespace {

constexpr double kWidth = 0.05;
constexpr double kPrior = 0.01;
constexpr double kWeight = 0.1;

ContactObservation freeAt(const Pose& pose) {
  ContactObservation observation;
  observation.state = ContactState::kFree;
  observation.T_world_object = pose;
  return observation;
}

ContactObservation contactAt(const Pose& pose, int id) {
  ContactObservation observation = freeAt(pose);
  observation.state = ContactState::kContact;
  observation.contact_id = id;
  return observation;
}

double kernel(double distance) { return std::exp(-0.5 * std::pow(distance / kWidth, 2)); }

Pose at(double x, double yaw = 0.0) { return makePose(Vec3(x, 0, 0), Vec3(0, 0, yaw)); }

TEST(BlockedMovements, ofWhatWasNeverTriedThePriorIsSaid) {
  const BlockedMovements map;
  EXPECT_DOUBLE_EQ(map.blocked(Pose::Identity()), kPrior);
  EXPECT_NEAR(map.success({at(0), at(10 * kWidth)}), std::pow(1 - kPrior, 10), 1e-12);
  EXPECT_EQ(map.success({at(0)}), 1.0);
}

TEST(BlockedMovements, aBlockedAndASuccessfulMovementCountByTheKernel) {
  BlockedMovements map;
  map.observe(contactAt(at(0.0), 1));
  for (const double distance : {0.0, 0.03, 0.05, 0.14}) {
    const double k = kernel(distance);
    const double expected = (kWeight * kPrior + k) / (kWeight + k);
    EXPECT_NEAR(map.blocked(at(distance)), expected, 1e-12);
    EXPECT_NEAR(map.blocked(at(0.0, distance)), expected, 1e-12) << "radians count as metres";
  }
  EXPECT_DOUBLE_EQ(map.blocked(at(0.151)), kPrior) << "beyond three widths";
  map.observe(freeAt(at(0.08)));
  const double k = kernel(0.04);
  EXPECT_NEAR(map.blocked(at(0.04)), (kWeight * kPrior + k) / (kWeight + 2 * k), 1e-12);
}

TEST(BlockedMovements, whatLiesBeyondTheContactIsBlockedNotWhatWasPassed) {
  BlockedMovements map;
  for (int i = 0; i <= 100; ++i) map.observe(freeAt(at(0.005 * i)));
  map.observe(contactAt(at(0.5), 1));
  EXPECT_LT(map.blocked(at(0.44)), 0.15);
  EXPECT_GT(map.blocked(at(0.57)), 0.5);
  EXPECT_GT(map.blocked(at(0.63)), 0.5);
}

TEST(BlockedMovements, neitherRatesNorReturnsNorTheRestOfAContactCount) {
  BlockedMovements once;
  BlockedMovements often;
  once.observe(freeAt(at(0.0)));
  once.observe(contactAt(at(0.01), 1));
  for (int i = 0; i < 100; ++i) often.observe(freeAt(at(0.0)));
  for (int i = 0; i < 100; ++i) often.observe(contactAt(at(0.01 + 1e-4 * i), 1));
  for (int i = 0; i < 100; ++i) often.observe(freeAt(at(0.0)));
  for (double x = -0.1; x < 0.1; x += 0.01) EXPECT_EQ(once.blocked(at(x)), often.blocked(at(x)));
}

TEST(BlockedMovements, whatIsBlockedAgainCountsAgain) {
  BlockedMovements map;
  for (int time = 1; time <= 3; ++time) {
    map.observe(contactAt(at(0.01 * time), time));
    const double k = time * kernel(0.09);
    EXPECT_NEAR(map.blocked(at(0.1)), (kWeight * kPrior + k) / (kWeight + k), 1e-12);
  }
}

TEST(BlockedMovements, agreesWithTheStrongestOfAllPosesInSpace) {
  BlockedMovements map;
  oracle::PoseSource source(3, 0.3, true);
  std::vector<Pose> contacts;  // none is counted twice: they lie apart
  while (contacts.size() < 300) {
    const Pose pose = source.next();
    const bool apart = std::all_of(contacts.begin(), contacts.end(), [&](const Pose& contact) {
      return gapBetween(contact, pose) > 0.5 * kWidth;
    });
    if (apart) contacts.push_back(pose);
  }
  for (int i = 0; i < 300; ++i) map.observe(contactAt(contacts[i], i + 1));
  int informed = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 aside = 0.08 * source.next().translation();
    const Pose pose = contacts[i] * makePose(aside);
    double strongest = 0.0;
    for (const Pose& contact : contacts) {
      const double gap = gapBetween(contact, pose);
      if (gap < 3 * kWidth) strongest = std::max(strongest, kernel(gap));
    }
    ASSERT_NEAR(map.blocked(pose), (kWeight * kPrior + strongest) / (kWeight + strongest), 1e-9);
    informed += strongest > 0.01 ? 1 : 0;
  }
  EXPECT_GT(informed, 200);
}

TEST(BlockedMovements, refusesParametersOutOfRange) {
  EXPECT_THROW(BlockedMovements({0.0, 0.01, 0.1}), std::invalid_argument);
  EXPECT_THROW(BlockedMovements({0.03, 0.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(BlockedMovements({0.03, 1.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(BlockedMovements({0.03, 0.01, 0.0}), std::invalid_argument);
}

TEST(MovementTrail, goesOnAsFarAsTheLastStep) {
  MovementTrail trail(0.1, 1.0);
  const Pose touch = makePose(Vec3(0.2, 0, 0), Vec3(0, 0, 0.1));
  EXPECT_EQ(trail.beyond(touch).matrix(), touch.matrix()) << "nothing is known of its motion";
  for (int i = 0; i < 200; ++i) trail.record(interpolate(Pose::Identity(), touch, i / 200.0));
  const Pose beyond = trail.beyond(touch);
  EXPECT_NEAR(gapBetween(touch, beyond), 0.1, 0.011);
  EXPECT_NEAR(beyond.translation().x() / 0.2, 2.0 * 0.5 + 0.333, 0.04);
  EXPECT_NEAR(angleBetween(Pose::Identity(), beyond), 0.1333, 0.004);
}

TEST(MovementTrail, forgetsTheWayToWhereTheObjectWasPutFrom) {
  MovementTrail trail(0.1, 1.0);
  for (int i = 0; i < 100; ++i) trail.record(at(0.01 * i));
  trail.record(at(0.0));
  const Pose touch = at(0.02);
  EXPECT_EQ(trail.beyond(touch).matrix(), touch.matrix());
}

/// The wall x = 0.25 is passed in its gap, y from 0.1 to 0.3, one time in two, elsewhere one time
/// in four.
class WallWithADoubtfulGap : public MovementBelief {
 public:
  double success(const Path& path) const override {
    double product = 1.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vec3 from = path[i - 1].translation();
      const Vec3 to = path[i].translation();
      if ((from.x() < 0.25) == (to.x() < 0.25)) continue;
      product *= to.y() > 0.1 && to.y() < 0.3 ? 0.5 : 0.25;
    }
    return product;
  }
};

// So few samples for each limit make short work of those that nothing passes.
MovementPlannerParameters quickSearch() {
  MovementPlannerParameters parameters;
  parameters.path.max_iterations = 4000;
  return parameters;
}

MotionSpace roomOf(double half_width) {
  MotionSpace space;
  space.workspace = {Vec3(-0.1, -half_width, 0.0), Vec3(0.6, half_width, 0.0)};
  return space;
}

TEST(MovementPlanner, passesTheLeastDoubtfulPlaceAndSaysHowLikelyItFails) {
  const WallWithADoubtfulGap wall;
  MovementPlannerParameters parameters;  // the gap takes more samples than 4000
  parameters.limits = {0.4, 0.5, 1.0};
  parameters.trees = 1;
  MovementPlanner planner(wall, roomOf(0.3), parameters, 1);
  const Pose goal = at(0.5);
  const auto plan = planner.plan(Pose::Identity(), goal);
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_EQ(plan->path.back().matrix(), goal.matrix());
  EXPECT_DOUBLE_EQ(plan->risk, 0.5) << "through the gap, and once";
}

TEST(MovementPlanner, passesADoubtfulPlaceWhereThereIsNoOther) {
  const WallWithADoubtfulGap wall;
  MovementPlanner planner(wall, roomOf(0.1), quickSearch(), 1);
  const auto plan = planner.plan(Pose::Identity(), at(0.5));
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_DOUBLE_EQ(plan->risk, 0.75);
}

TEST(MovementPlanner, saysWhyThereIsNoPlan) {
  const WallWithADoubtfulGap wall;
  MovementPlanner planner(wall, roomOf(0.1), quickSearch(), 1);
  const auto plan = planner.plan(Pose::Identity(), at(0.7));
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.reason().find("goal"), std::string::npos) << plan.reason();
}

TEST(MovementPlanner, refusesParametersOutOfRange) {
  const WallWithADoubtfulGap wall;
  const auto refuses = [&](std::vector<double> limits, int trees) {
    const MovementPlannerParameters parameters{{}, std::move(limits), trees};
    EXPECT_THROW(MovementPlanner(wall, roomOf(0.1), parameters, 1), std::invalid_argument);
  };
  refuses({1.0}, 0);
  refuses({}, 1);
  refuses({0.5}, 1);
  refuses({0.5, 0.2, 1.0}, 1);
  refuses({-0.1, 1.0}, 1);
}

TEST(MovementPlanner, makesTheSamePlansFromTheSameSeed) {
  const WallWithADoubtfulGap wall;
  MovementPlanner first(wall, roomOf(0.3), quickSearch(), 7);
  MovementPlanner second(wall, roomOf(0.3), quickSearch(), 7);
  for (int call = 0; call < 2; ++call) {
    const auto a = first.plan(Pose::Identity(), at(0.5));
    const auto b = second.plan(Pose::Identity(), at(0.5));
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->path.size(), b->path.size());
    for (std::size_t i = 0; i < a->path.size(); ++i) {
      EXPECT_EQ(a->path[i].matrix(), b->path[i].matrix());
    }
  }
}

TEST(MovementPlanner, goesAroundABlockedPlace) {
  BlockedMovements map;
  for (int yaw = -3; yaw <= 3; ++yaw) map.observe(contactAt(at(0.25, 0.1 * yaw), yaw + 4));
  MovementPlanner planner(map, roomOf(0.4), quickSearch(), 1);
  const auto plan = planner.plan(Pose::Identity(), at(0.5));
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_NEAR(plan->risk, 1.0 - map.success(plan->path), 1e-12);
  EXPECT_LT(plan->risk, 0.5);
  EXPECT_GT(1.0 - map.success({Pose::Identity(), at(0.5)}), 0.9);
}

}  // namespace
}  // namespace smore
