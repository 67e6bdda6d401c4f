// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scripted_robot.h"
#include "smore/retrieval/retrieval.h"

namespace smore {
namespace {

MotionResult contact() {
  MotionResult result;
  result.end = MotionEnd::kContact;
  return result;
}

MotionResult fault(const std::string& reason) {
  MotionResult result;
  result.end = MotionEnd::kFault;
  result.reason = reason;
  return result;
}

// Straight to the goal by way of a point that is different in each call, or nothing for the first
// `failures` calls.
class DetourPlanner : public Planner {
 public:
  int failures = 0;
  int calls = 0;
  double spread = 1.0;               // [m] between the detours
  std::string out;                   // why it cannot be asked
  std::vector<std::size_t> avoided;  // how many places, by call

  std::string outage() const override { return out; }

  Result<Plan> plan(const Pose& start, const Pose& goal) override {
    ++calls;
    avoided.push_back(refused_.size());
    if (failures-- > 0) return Failure{"walled in"};
    return Plan{{start, makePose(Vec3(0, spread * calls, 0)), goal}, 0.25};
  }
};

RetrievalParameters parameters() {
  RetrievalParameters parameters;
  parameters.goal = makePose(Vec3(-1, 0, 0));
  return parameters;
}

class RetrievalTest : public ::testing::Test {
 protected:
  RetrievalOutcome run(const RetrievalParameters& parameters) {
    Retrieval retrieval(parameters, &robot_, &planner_,
                        [this](const RetrievalProgress& progress) { news_.push_back(progress); });
    return retrieval.run();
  }

  ScriptedRobot robot_;
  DetourPlanner planner_;
  std::vector<RetrievalProgress> news_;
};

TEST_F(RetrievalTest, endsAtTheGoal) {
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.collisions, 0);
  EXPECT_EQ(outcome.plans, 1);
  EXPECT_NEAR(outcome.path_length, pathLength(outcome.path), 1e-12);
  ASSERT_EQ(news_.size(), 3u);
  EXPECT_EQ(news_[0].phase, Phase::kPlanning);
  EXPECT_EQ(news_[1].phase, Phase::kMoving);
  EXPECT_EQ(news_[1].risk, RiskCalibration(Motion::kPlanar).corrected(0.25));
  EXPECT_EQ(news_[2].phase, Phase::kFinished);
}

TEST_F(RetrievalTest, resetsToTheStartAfterEachContact) {
  robot_.script = {contact(), contact()};
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.collisions, 2);
  ASSERT_EQ(outcome.motions.size(), 3u);
  EXPECT_TRUE(outcome.motions[1].touched);
  EXPECT_FALSE(outcome.motions[2].touched);
  RiskCalibration calibration(parameters().motion);
  for (const PlannedMotion& motion : outcome.motions) {
    EXPECT_EQ(motion.risk, calibration.corrected(0.25));
    calibration.learn(0.25, motion.touched);
  }
  EXPECT_GT(outcome.motions[2].risk, outcome.motions[0].risk) << "both before it touched";
  EXPECT_EQ(robot_.calls,
            (std::vector<std::string>{"follow", "reset", "follow", "reset", "follow"}));
}

TEST_F(RetrievalTest, retreatsWhereAskedTo) {
  robot_.script = {contact(), contact()};
  RetrievalParameters retreating = parameters();
  retreating.on_contact = OnContact::kRetreat;
  EXPECT_TRUE(run(retreating).success);
  EXPECT_EQ(robot_.calls,
            (std::vector<std::string>{"follow", "retreat", "follow", "retreat", "follow"}));
}

TEST_F(RetrievalTest, resetsWhenARetreatLedBackToTheSameContact) {
  planner_.spread = 0.0;
  robot_.script = {contact(), contact()};
  RetrievalParameters retreating = parameters();
  retreating.on_contact = OnContact::kRetreat;
  EXPECT_TRUE(run(retreating).success);
  EXPECT_EQ(robot_.calls,
            (std::vector<std::string>{"follow", "retreat", "follow", "reset", "follow"}));
}

TEST_F(RetrievalTest, givesUpAtTheCollisionLimit) {
  robot_.script.assign(100, contact());
  RetrievalParameters limited = parameters();
  limited.max_collisions = 7;
  const RetrievalOutcome outcome = run(limited);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.collisions, 7);
  EXPECT_NE(outcome.reason.find("limit of 7"), std::string::npos);
  EXPECT_EQ(robot_.calls.back(), "reset") << "it presses still";
}

// A tolerance below the accuracy of the robot.
TEST_F(RetrievalTest, givesUpWhereTheRobotKeepsEndingBesideTheGoal) {
  robot_.miss = 0.0015;
  RetrievalParameters fine = parameters();
  fine.goal_position_tolerance = 0.001;
  const RetrievalOutcome outcome = run(fine);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.plans, fine.max_failed_plans);
  EXPECT_NE(outcome.reason.find("0.0015 m"), std::string::npos) << outcome.reason;
  EXPECT_NE(outcome.reason.find("goal_tolerance"), std::string::npos) << outcome.reason;
}

TEST_F(RetrievalTest, doesNotMoveWhatIsAtTheGoalAlready) {
  RetrievalParameters there = parameters();
  there.goal = makePose(Vec3(0.01, 0, 0), Vec3(0, 0, 0.05));
  const RetrievalOutcome outcome = run(there);
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.plans, 0);
  EXPECT_TRUE(robot_.calls.empty());
  ASSERT_EQ(news_.size(), 1u);
  EXPECT_EQ(news_[0].phase, Phase::kFinished);
}

TEST_F(RetrievalTest, triesAgainFromTheStartWithoutAPlan) {
  planner_.failures = 3;
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.plans, 4);
  EXPECT_EQ(robot_.calls, (std::vector<std::string>{"reset", "reset", "reset", "follow"}));
}

TEST_F(RetrievalTest, givesUpWithTheLastReasonWhenThereIsNoPlan) {
  planner_.failures = 1000;
  RetrievalParameters limited = parameters();
  limited.max_failed_plans = 5;
  const RetrievalOutcome outcome = run(limited);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.plans, 5);
  EXPECT_NE(outcome.reason.find("walled in"), std::string::npos);
}

TEST_F(RetrievalTest, endsWithTheReasonOfAFault) {
  robot_.script = {contact(), fault("the sensor is silent")};
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.reason, "the sensor is silent");
  EXPECT_EQ(outcome.collisions, 1);
}

MotionResult refusal() {
  MotionResult result;
  result.end = MotionEnd::kUnreachable;
  result.reason = "pose 2 of 3 is out of reach";
  result.refused_at = makePose(Vec3(0.0, 1.0, 0.0));
  return result;
}

TEST_F(RetrievalTest, plansAnewWhereTheRobotCannotFollow) {
  robot_.script = {refusal(), refusal()};
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.plans, 3);
  EXPECT_EQ(outcome.collisions, 0);
}

// Until it moves: from elsewhere the robot may be able to be there.
TEST_F(RetrievalTest, tellsThePlannerWhereTheRobotCannotFollow) {
  MotionResult touch;
  touch.end = MotionEnd::kContact;
  robot_.script = {refusal(), refusal(), touch, refusal()};
  EXPECT_TRUE(run(parameters()).success);
  EXPECT_EQ(planner_.avoided, (std::vector<std::size_t>{0, 1, 2, 0, 1}));
}

TEST_F(RetrievalTest, staysWhereItIsWhileThePlannerCannotBeAsked) {
  planner_.failures = 100;
  planner_.out = "no answer";
  RetrievalParameters few = parameters();
  few.max_failed_plans = 3;
  const RetrievalOutcome outcome = run(few);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.reason, "no plan in 3 attempts; the last said: walled in");
  EXPECT_TRUE(robot_.calls.empty());
}

TEST_F(RetrievalTest, givesUpWithTheReasonWhenTheRobotRefusesEveryPlan) {
  RetrievalParameters few = parameters();
  few.max_failed_plans = 3;
  robot_.script = {refusal(), refusal(), refusal(), refusal()};
  const RetrievalOutcome outcome = run(few);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.plans, 3);
  EXPECT_EQ(outcome.reason, "pose 2 of 3 is out of reach");
}

TEST_F(RetrievalTest, endsWhenItCannotBackOff) {
  robot_.script = {contact()};
  robot_.reset_end = MotionEnd::kFault;
  const RetrievalOutcome outcome = run(parameters());
  EXPECT_FALSE(outcome.success);
  EXPECT_NE(outcome.reason.find("stuck"), std::string::npos);
}

// Whoever asks for the stop while a plan is made may get no plan, or one.
TEST_F(RetrievalTest, doesNotMoveWhenStoppedWhileItPlans) {
  for (const int failures : {0, 1000}) {
    robot_.calls.clear();
    planner_.failures = failures;
    Retrieval retrieval(parameters(), &robot_, &planner_, [&](const RetrievalProgress& progress) {
      if (progress.phase != Phase::kPlanning) retrieval.requestStop();
    });
    const RetrievalOutcome outcome = retrieval.run();
    EXPECT_FALSE(outcome.success);
    EXPECT_EQ(outcome.reason, "stopped by the user");
    EXPECT_TRUE(robot_.calls.empty());
  }
}

TEST_F(RetrievalTest, stopsWhenAskedTo) {
  Retrieval retrieval(parameters(), &robot_, &planner_, {});
  retrieval.requestStop();
  const RetrievalOutcome outcome = retrieval.run();
  EXPECT_FALSE(outcome.success);
  EXPECT_TRUE(robot_.calls.empty());
  EXPECT_NE(outcome.reason.find("stopped"), std::string::npos);
}

}  // namespace
}  // namespace smore
