// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/planning/contact_risk.h"
#include "smore/planning/risk_planner.h"

namespace smore {
namespace {

const Pose kStart = makePose({0, 0, 0});
const Pose kGoal = makePose({-1, 0, 0});

MotionSpace spaceOf(Motion motion) {
  const double z = motion == Motion::kPlanar ? 0.01 : 0.4;
  return {motion, kStart, {Vec3(-1.3, -0.7, -z), Vec3(0.4, 0.7, z)}};
}

JointBelief emptyBelief(Motion motion) {
  JointBeliefParameters parameters;
  if (motion == Motion::kPlanar) parameters.T_world_plane = kStart;
  return JointBelief(parameters);
}

// The straight way to the goal is blocked after `x` metres: a contact ahead of the hand.
void block(double x, JointBelief* belief) {
  for (double free = 0.0; free < x; free += 0.005) {
    ContactObservation observation;
    observation.state = ContactState::kFree;
    observation.T_world_object = makePose({-free, 0, 0});
    belief->observe(observation);
  }
  ContactObservation observation;
  observation.state = ContactState::kContact;
  observation.T_world_object = makePose({-x, 0, 0});
  LineOfAction line;
  line.direction = Vec3::UnitX();
  observation.line = line;
  belief->observe(observation);
}

class RiskPlannerIn : public testing::TestWithParam<Motion> {};

TEST_P(RiskPlannerIn, GoesStraightWhereNothingIsKnown) {
  const JointBelief belief = emptyBelief(GetParam());
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(pathLength(plan->path), 1.0, 0.05);
  // One contact a metre is the prior for what nothing has touched yet.
  EXPECT_NEAR(plan->risk, 1.0 - std::exp(-1.0), 0.03);
  EXPECT_TRUE(plan->path.front().isApprox(kStart));
  EXPECT_TRUE(plan->path.back().isApprox(kGoal));
}

TEST_P(RiskPlannerIn, DoesNotRepeatAContact) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.3, &belief);
  const ContactRisk risk(belief);
  EXPECT_GT(risk.along({kStart, kGoal}), 0.9);
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan);
  EXPECT_LT(risk.along(plan->path), 0.5);
  EXPECT_DOUBLE_EQ(plan->risk, risk.ofMotion(plan->path));
  for (const Pose& pose : plan->path)
    EXPECT_TRUE(spaceOf(GetParam()).workspace.contains(pose.translation() * (1.0 - 1e-4)));
}

TEST_P(RiskPlannerIn, TheSameSeedGivesTheSamePaths) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.2, &belief);
  RiskPlanner first(belief, spaceOf(GetParam()), {}, 5);
  RiskPlanner second(belief, spaceOf(GetParam()), {}, 5);
  const auto a = first.plan(kStart, kGoal);
  const auto b = second.plan(kStart, kGoal);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->path.size(), b->path.size());
  for (std::size_t i = 0; i < a->path.size(); ++i) {
    EXPECT_EQ(a->path[i].matrix(), b->path[i].matrix());
  }
}

TEST_P(RiskPlannerIn, SaysWhyThereIsNoPlan) {
  const JointBelief belief = emptyBelief(GetParam());
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto outside = planner.plan(kStart, makePose({-2, 0, 0}));
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.reason(), "the goal is outside of the workspace");
  EXPECT_FALSE(planner.plan(makePose({2, 0, 0}), kGoal));
}

INSTANTIATE_TEST_SUITE_P(Motions, RiskPlannerIn,
                         testing::Values(Motion::kPlanar, Motion::kSpatial));

}  // namespace
}  // namespace smore
