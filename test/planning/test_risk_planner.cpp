// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "known_boxes.h"
#include "smore/planning/contact_risk.h"
#include "smore/planning/risk_planner.h"

namespace smore {
namespace {

const Pose kStart = makePose({0, 0, 0});
const Pose kGoal = makePose({-1, 0, 0});

constexpr double kUnit = 0.1;  // of length [m]

MotionSpace spaceOf(Motion motion) {
  const double z = motion == Motion::kPlanar ? 0.01 : 0.4;
  return {motion, kStart, {Vec3(-1.3, -0.7, -z), Vec3(0.4, 0.7, z)}};
}

JointBelief emptyBelief(Motion motion) {
  JointBeliefParameters parameters;
  parameters.unit = kUnit;
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
  EXPECT_GT(plan->risk, 0.95) << "a metre through what nobody knows";
  EXPECT_TRUE(plan->path.front().isApprox(kStart));
  EXPECT_TRUE(plan->path.back().isApprox(kGoal));
}

double nearest(const Path& path, const Pose& place) {
  double least = 1e9;
  for (const Pose& pose : densify(path, 0.005, 0.02)) {
    least = std::min(least, distanceBetween(pose, place) + angleBetween(pose, place));
  }
  return least;
}

TEST_P(RiskPlannerIn, PassesBesideWhereTheRobotCannotBe) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.3, &belief);
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  std::vector<Pose> refused{makePose({-0.2, 0, 0})};  // on a way that the object has come
  for (int i = 0; i < 5; ++i) {
    planner.avoid(refused);
    const auto plan = planner.plan(kStart, kGoal);
    ASSERT_TRUE(plan);
    for (const Pose& place : refused) EXPECT_GT(nearest(plan->path, place), 0.05) << i;
    const Path dense = densify(plan->path, 0.005, 0.02);
    refused.push_back(dense[dense.size() / 2]);
  }
}

// What is refused where it stands bars nothing.
TEST_P(RiskPlannerIn, FindsAPathThoughTheRobotCannotSetOut) {
  const JointBelief belief = emptyBelief(GetParam());
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  planner.avoid({kStart, kGoal, makePose({-1e-5, 0, 0})});
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(pathLength(plan->path), 1.0, 0.05);
}

TEST_P(RiskPlannerIn, DoesNotRepeatAContact) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.3, &belief);
  const ContactRisk risk(belief.worlds());
  EXPECT_GT(risk.along({kStart, kGoal}), 0.9);
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan);
  EXPECT_LT(risk.along(plan->path), 0.5);
  EXPECT_DOUBLE_EQ(plan->risk, risk.ofMotion(plan->path));
  for (const Pose& pose : plan->path)
    EXPECT_TRUE(spaceOf(GetParam()).workspace.contains(pose.translation() * (1.0 - 1e-4)));
}

// What is left out of an improvement, because it can no longer be better, changes no value.
TEST_P(RiskPlannerIn, ImprovesAPathByItsOwnMeasure) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.3, &belief);
  constexpr double kLever = 3.0 * kUnit;
  const RiskSpace space(spaceOf(GetParam()), Pose::Identity(), kLever);
  const std::shared_ptr<const Worlds> worlds = belief.worlds();
  const RiskMotions motions(worlds->sampled, kLever);
  const SweptRoom room(*worlds, space, motions);
  const PathValue measure({200.0 * kUnit, 0.2 * kUnit}, &room, 1.0);
  std::vector<RiskState> states;
  for (const double y : {0.0, 0.2, -0.3, 0.1, 0.3, 0.0}) {
    states.push_back(space.toState(makePose({-0.2 * static_cast<double>(states.size()), y, 0})));
  }
  RiskPath path(motions, measure, states);
  const double before = path.value();
  CounterRandom random(3);
  path.improve(space, 40, 0.05, Deadline(60.0), &random);
  EXPECT_LT(path.value(), before);
  const RiskPath anew(motions, measure, path.states());
  EXPECT_NEAR(path.value(), anew.value(), 1e-4);
}

// A contact whose line did not come, or says nothing, is still known to be there.
TEST_P(RiskPlannerIn, DoesNotRepeatAContactWithoutALine) {
  JointBelief belief = emptyBelief(GetParam());
  ContactObservation observation;
  observation.state = ContactState::kContact;
  observation.contact_id = 1;
  observation.T_world_object = makePose({-0.3, 0, 0});
  belief.observe(observation);
  EXPECT_EQ(ContactRisk(belief.worlds()).along({kStart, kGoal}), 1.0);
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan);
  EXPECT_EQ(ContactRisk(belief.worlds()).along(plan->path), 0.0);
  // Once the line has come, the sampled worlds say where such a motion touches.
  observation.line = LineOfAction{};
  observation.line->direction = Vec3::UnitX();
  belief.observe(observation);
  EXPECT_LT(ContactRisk(belief.worlds()).atPose(makePose({-0.3, 0.02, 0})), 1.0);
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

// What a path is worth where matter that nobody knows of is left out.
double valueOf(const Path& path, const JointBelief& belief, const MotionSpace& motion_space,
               const RiskPlannerParameters& parameters) {
  const std::shared_ptr<const Worlds> worlds = belief.worlds();
  const RiskSpace space(motion_space, worlds->frame.T_map_world(), parameters.lever * worlds->held);
  const RiskMotions motions(worlds->sampled, space.lever(), space.fullTurns());
  const RiskObjective& objective = parameters.objective;
  const PathValue measure({objective.touch_cost * kUnit, objective.give * kUnit}, nullptr, 0.0);
  std::vector<RiskState> states;
  for (const Pose& pose : path) states.push_back(space.toState(pose));
  return RiskPath(motions, measure, states).value();
}

// However little time there is, there is a path; and a better one where there is time. How good a
// path is that a part of a second finds is the machine's affair, and nothing is said of it here.
TEST_P(RiskPlannerIn, TakesTheBestPathAtTheDeadline) {
  JointBelief belief = emptyBelief(GetParam());
  block(0.3, &belief);
  RiskPlannerParameters patient;
  patient.surprise_share_in_space = 0.0;
  RiskPlannerParameters hasty = patient;
  hasty.time_limit = 1e-9;
  RiskPlannerParameters endless = patient;
  endless.iterations = 1000000000;
  endless.paths = 1000000000;
  endless.time_limit = 0.2;
  std::vector<double> values;
  for (const RiskPlannerParameters& parameters : {patient, hasty, endless}) {
    RiskPlanner planner(belief, spaceOf(GetParam()), parameters, 1);
    const auto plan = planner.plan(kStart, kGoal);
    ASSERT_TRUE(plan);
    EXPECT_TRUE(plan->path.front().isApprox(kStart));
    EXPECT_TRUE(plan->path.back().isApprox(kGoal));
    values.push_back(valueOf(plan->path, belief, spaceOf(GetParam()), parameters));
  }
  EXPECT_LT(values[0], values[1]);
}

TEST_P(RiskPlannerIn, SaysWhyThereIsNoPlan) {
  const JointBelief belief = emptyBelief(GetParam());
  RiskPlanner planner(belief, spaceOf(GetParam()), {}, 1);
  const auto outside = planner.plan(kStart, makePose({-2, 0, 0}));
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.reason(), "the goal is outside of the workspace");
  EXPECT_FALSE(planner.plan(makePose({2, 0, 0}), kGoal));
}

// An arm that was sent to an edge of the workspace is never quite there.
TEST_P(RiskPlannerIn, StartsALittleBesideTheWorkspace) {
  const JointBelief belief = emptyBelief(GetParam());
  const MotionSpace space = spaceOf(GetParam());
  RiskPlanner planner(belief, space, {}, 1);
  const double edge = space.workspace.max.x();
  const auto plan = planner.plan(makePose({edge + 0.005, 0, 0}), kGoal);
  ASSERT_TRUE(plan) << plan.reason();
  for (std::size_t i = 1; i < plan->path.size(); ++i) {
    EXPECT_LT(plan->path[i].translation().x(), edge + 1e-4);
  }
  EXPECT_FALSE(planner.plan(makePose({edge + 0.02, 0, 0}), kGoal));
}

// How far a bar along y has turned towards the way ahead when it is half-way: 1 when it goes end
// first, 0 when it goes broadside. Nothing has been touched yet.
double endFirst(bool known, const RiskPlannerParameters& parameters) {
  JointBelief belief = emptyBelief(Motion::kSpatial);
  if (known) {
    belief.know(MapSide::kObject, boxKnown({-0.02, -0.3, -0.02}, {0.02, 0.3, 0.02}, 0.1));
  }
  RiskPlanner planner(belief, spaceOf(Motion::kSpatial), parameters, 1);
  const auto plan = planner.plan(kStart, kGoal);
  const Path poses = plan ? densify(plan->path, 0.01, 0.1) : Path{};
  for (const Pose& pose : poses) {
    if (pose.translation().x() < -0.5) return std::abs(pose.linear()(0, 1));
  }
  return -1.0;
}

// Where the object is known, what it sweeps is no guess; where it is not, there is none to make.
TEST(RiskPlanner, EntersLittleNewRoomFromTheFirstMotionOnWhereTheObjectIsKnown) {
  EXPECT_GT(endFirst(true, {}), 0.9);
  EXPECT_NEAR(endFirst(false, {}), 0.0, 0.1);
  RiskPlannerParameters no_surprises;
  no_surprises.surprises_of_known_object = 0.0;
  EXPECT_NEAR(endFirst(true, no_surprises), 0.0, 0.1);
}

// From 2 to -2 rad the shorter turn leads past half a turn; an arm has to go the longer way.
TEST(RiskPlanner, KeepsWithinHalfATurnWhereAnArmHolds) {
  MotionSpace space = spaceOf(Motion::kPlanar);
  space.full_turns = false;
  const JointBelief belief = emptyBelief(Motion::kPlanar);
  RiskPlanner planner(belief, space, {}, 1);
  const Pose from = makePose(Vec3(0, 0, 0), Vec3(0, 0, 2));
  const auto plan = planner.plan(from, makePose(Vec3(-0.2, 0, 0), Vec3(0, 0, -2)));
  ASSERT_TRUE(plan);
  double turned = 0.0;
  for (std::size_t i = 1; i < plan->path.size(); ++i) {
    const Eigen::Matrix3d turn = plan->path[i - 1].linear().transpose() * plan->path[i].linear();
    turned += std::atan2(turn(1, 0), turn(0, 0));
    EXPECT_GT(2.0 + turned, -M_PI);
    EXPECT_LT(2.0 + turned, M_PI);
  }
  EXPECT_NEAR(turned, -4.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Motions, RiskPlannerIn,
                         testing::Values(Motion::kPlanar, Motion::kSpatial));

}  // namespace
}  // namespace smore
