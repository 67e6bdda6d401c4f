// SPDX-License-Identifier: BSD-3-Clause
// What nodes tell of themselves on /diagnostics: levels with their reasons.
#include <gtest/gtest.h>

#include "smore/ros/guard_status.h"
#include "smore/ros/listener_status.h"
#include "smore/ros/mapping_status.h"
#include "smore/ros/planner_status.h"

namespace smore {
namespace {

std::string valueOf(const Status& status, const std::string& key) {
  for (const auto& pair : status.values) {
    if (pair.key == key) return pair.value;
  }
  return "there is no " + key;
}

void expectStatus(const Status& status, int level, const std::string& words) {
  EXPECT_EQ(int{status.level}, level) << status.message;
  EXPECT_NE(status.message.find(words), std::string::npos) << status.message;
}

WrenchReport fiveHundred() {
  WrenchReport report;
  report.received = 500;
  report.period = 0.002;
  report.jitter = 0.0001;
  return report;
}

template <typename NodeStatus, typename Report>
Status told(NodeStatus* status, const Report& report) {
  Status result;
  status->compose(report, &result);
  return result;
}

TEST(WrenchStatus, isStaleBeforeAWrenchHasComeAndWhenNoneComesAnyMore) {
  WrenchStatus status;
  WrenchReport report;
  expectStatus(told(&status, report), Status::STALE, "no wrench has come");
  report = fiveHundred();
  report.silence = 1.9;
  expectStatus(told(&status, report), Status::OK, "wrenches come");
  report.silence = 2.1;
  expectStatus(told(&status, report), Status::STALE, "no wrench for 2.1 s");
}

TEST(WrenchStatus, givesRateJitterAndAge) {
  WrenchStatus status;
  WrenchReport report = fiveHundred();
  report.silence = 0.25;
  const Status result = told(&status, report);
  EXPECT_EQ(valueOf(result, "rate [Hz]"), "500");
  EXPECT_EQ(valueOf(result, "jitter [s]"), "0.0001");
  EXPECT_EQ(valueOf(result, "age [s]"), "0.25");
}

TEST(WrenchStatus, warnsOfDroppedWrenchesOnceAndCountsThem) {
  WrenchStatus status;
  WrenchReport report = fiveHundred();
  told(&status, report);
  report.received += 500;
  report.dropped.repeated = 2;
  report.dropped.poseless = 3;
  const Status dropped = told(&status, report);
  expectStatus(dropped, Status::WARN, "5 wrenches dropped");
  EXPECT_EQ(valueOf(dropped, "dropped for want of a pose"), "3");
  report.received += 500;
  const Status after = told(&status, report);
  expectStatus(after, Status::OK, "wrenches come");
  EXPECT_EQ(valueOf(after, "dropped"), "5");
}

TEST(WrenchStatus, isAnErrorWhereAllWrenchesAreDropped) {
  WrenchStatus status;
  WrenchReport report = fiveHundred();
  told(&status, report);
  report.received += 500;
  report.dropped.poseless = 500;
  expectStatus(told(&status, report), Status::ERROR, "all are dropped");
}

TEST(WrenchStatus, warnsOfARateThatIsNotTheOneThatItWasTold) {
  WrenchStatus status;
  WrenchReport report = fiveHundred();
  report.period = 0.008;
  expectStatus(told(&status, report), Status::WARN, "125 Hz, noise/sample_period says 500 Hz");
  report.period = 0.001;
  expectStatus(told(&status, report), Status::WARN, "1000 Hz");
}

SensorReport tared() {
  SensorReport report;
  report.tared = true;
  report.bias.force = {1.0, -2.0, 0.5};
  report.bias_stddev = 0.1;
  report.range = wristSensorRange(RobotKind::kUr5e);
  return report;
}

TEST(SensorStatus, givesTheBiasAndHowWellItIsKnown) {
  SensorStatus status;
  const Status result = told(&status, tared());
  expectStatus(result, Status::OK, "known to 0.10 N");
  EXPECT_EQ(valueOf(result, "uncertainty of the force's bias [N]"), "0.1");
  EXPECT_EQ(valueOf(result, "range of the force [N]"), "50");
}

TEST(SensorStatus, isStaleBeforeTheTareAndWarnsOfOneThatWasRefused) {
  SensorStatus status;
  SensorReport report;
  expectStatus(told(&status, report), Status::STALE, "not tared yet");
  report.tare_problem = "the robot was not still";
  expectStatus(told(&status, report), Status::WARN, "the robot was not still");
}

TEST(SensorStatus, warnsOfABiasThatHidesFreeSpace) {
  SensorStatus status;
  SensorReport report = tared();
  report.bias_stddev = 0.6;
  expectStatus(told(&status, report), Status::WARN, "known to 0.60 N only");
}

TEST(SensorStatus, isAnErrorWhileSamplesAreAtTheEndOfTheRange) {
  SensorStatus status;
  SensorReport report = tared();
  report.saturated = 7;
  expectStatus(told(&status, report), Status::ERROR, "7 samples at the end");
  expectStatus(told(&status, report), Status::OK, "tared");
}

TEST(SensorStatus, warnsOfContactsThatEndedWithoutALineAndCountsThem) {
  SensorStatus status;
  SensorReport report = tared();
  report.lineless = 2;
  expectStatus(told(&status, report), Status::WARN, "2 contacts ended");
  report.lineless = 3;
  report.bias_stddev = 0.6;
  const Status both = told(&status, report);
  expectStatus(both, Status::WARN, "known to 0.60 N only");
  expectStatus(both, Status::WARN, "1 contacts ended");
  EXPECT_EQ(valueOf(both, "contacts without a line"), "3");
  report.bias_stddev = 0.1;
  expectStatus(told(&status, report), Status::OK, "tared");
}

TEST(Saturation, isAnyAxisAtTheEndOfTheRangeOrBeyond) {
  const WrenchRange range = wristSensorRange(RobotKind::kUr5e);
  Wrench wrench;
  wrench.force = {49.0, -49.0, 0.0};
  wrench.torque = {9.9, 0.0, 0.0};
  EXPECT_FALSE(isSaturated(wrench, range));
  EXPECT_FALSE(isSaturated(wrench, wristSensorRange(RobotKind::kCartesian)));
  wrench.torque.z() = -10.0;
  EXPECT_TRUE(isSaturated(wrench, range));
  wrench.torque.z() = 0.0;
  wrench.force.y() = -50.0;
  EXPECT_TRUE(isSaturated(wrench, range));
}

Status told(const MappingReport& report) {
  Status result;
  compose(report, &result);
  return result;
}

TEST(MappingStatus, isStaleWithoutObservationsOrWithOldOnes) {
  MappingReport report;
  expectStatus(told(report), Status::STALE, "no observation has come");
  report.pose_age = 1.2;
  expectStatus(told(report), Status::STALE, "1.2 s old");
  report.pose_age = 0.01;
  expectStatus(told(report), Status::OK, "maps of 0 contacts");
}

TEST(MappingStatus, warnsOfMapsThatFallBehind) {
  MappingReport report;
  report.pose_age = 0.01;
  report.waiting = 5000;
  expectStatus(told(report), Status::WARN, "5000 observations wait");
}

TEST(MappingStatus, warnsOfAnObservationThatWasLeftOutForTenSeconds) {
  MappingReport report;
  report.pose_age = 0.01;
  note(KeeperProblems{"observation left out", ""}, &report);
  note(KeeperProblems{}, &report);
  expectStatus(told(report), Status::WARN, "observation left out");
  report.left_out_at -= std::chrono::seconds(10);
  expectStatus(told(report), Status::OK, "maps of 0 contacts");
}

TEST(MappingStatus, warnsOfTheJournalsEndForGoodAndBesideAllElse) {
  MappingReport report;
  report.pose_age = 0.01;
  note(KeeperProblems{"", "the journal ends here"}, &report);
  note(KeeperProblems{"observation left out", ""}, &report);
  expectStatus(told(report), Status::WARN, "the journal ends here");
  expectStatus(told(report), Status::WARN, "observation left out");
  report.left_out_at -= std::chrono::hours(1);
  report.waiting = 5000;
  expectStatus(told(report), Status::WARN, "the journal ends here");
  expectStatus(told(report), Status::WARN, "5000 observations wait");
  report.pose_age.reset();
  expectStatus(told(report), Status::STALE, "the journal ends here");
}

TEST(MappingStatus, givesTheSizesOfTheMapsOnceSomebodyHasAskedForThem) {
  MappingReport report;
  report.pose_age = 0.01;
  report.world_voxels = 1234;
  const Status result = told(report);
  EXPECT_EQ(valueOf(result, "voxels of the world map"), "1234");
  EXPECT_EQ(valueOf(result, "voxels of the object map"), "nobody has asked for the map");
  EXPECT_GT(std::stod(valueOf(result, "memory [MiB]")), 1.0);
}

Status told(const PlannerStatus& status) {
  Status result;
  status.compose(&result);
  return result;
}

TEST(PlannerStatus, tellsWhatBecameOfTheLastPlan) {
  PlannerStatus status;
  expectStatus(told(status), Status::OK, "no plan asked for yet");
  status.begin();
  expectStatus(told(status), Status::OK, "planning for 0.");
  status.find(0.5, 0.25);
  expectStatus(told(status), Status::OK, "the last plan took");
  EXPECT_EQ(valueOf(told(status), "risk of the last plan"), "0.25");
  status.begin();
  status.refuse("there is no way");
  expectStatus(told(status), Status::WARN, "refused: there is no way");
  status.begin();
  status.find(0.5, std::nullopt);
  expectStatus(told(status), Status::OK, "the last plan took");
  EXPECT_EQ(valueOf(told(status), "plans"), "2");
  EXPECT_EQ(valueOf(told(status), "plans refused"), "1");
}

Status told(const GuardReport& report) {
  Status result;
  compose(report, &result);
  return result;
}

TEST(GuardStatus, isAnErrorAtAFaultAndWarnsWhileAMotionWaits) {
  GuardReport report;
  report.lateness = "no wrench for 0.06 s";
  expectStatus(told(report), Status::OK, "may move");
  report.moving = true;
  expectStatus(told(report), Status::WARN, "waits: no wrench");
  report.lateness.clear();
  expectStatus(told(report), Status::OK, "moves");
  report.fault = "the force is 45 N";
  expectStatus(told(report), Status::ERROR, "45 N");
}

}  // namespace
}  // namespace smore
