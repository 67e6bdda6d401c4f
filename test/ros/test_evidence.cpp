// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "smore/common/result.h"
#include "smore/ros/evidence_log.h"
#include "smore/ros/map_keeper.h"
#include "smore/ros/method_replica.h"

namespace smore {
namespace {

constexpr double kLongEnough = 20.0;  // [s]; a wait that fails takes this long

ContactObservation freeAt(double time, double x) {
  ContactObservation observation;
  observation.time = time;
  observation.T_world_object = makePose({x, 0.0, 0.0});
  observation.state = ContactState::kFree;
  return observation;
}

ContactObservation contactAt(double time, double x, int id) {
  ContactObservation observation = freeAt(time, x);
  observation.state = ContactState::kContact;
  observation.contact_id = id;
  return observation;
}

ContactObservation lineAt(double time, double x, int id) {
  ContactObservation observation = contactAt(time, x, id);
  LineOfAction line;
  line.point = {0.0, 0.2, 0.0};
  line.direction = -Vec3::UnitX();
  line.force = 6.0;
  observation.line = line;
  return observation;
}

Scenario plainScenario() {
  Scenario scenario;
  scenario.goal = makePose({-0.3, 0.0, 0.0});
  scenario.workspace = {{-0.5, -0.5, -0.01}, {0.5, 0.5, 0.01}};
  return scenario;
}

MapKeeper::MakeMaps emptyMaps(MethodKind kind) {
  return [kind](const Priors& priors) { return makeTwinMap(kind, plainScenario(), 1, {}, priors); };
}

TEST(EvidenceLog, KeepsWhatIsNewAndLeavesOutRepetitions) {
  EvidenceLog log({0.003, 0.01});
  EXPECT_TRUE(log.add(freeAt(0.0, 0.0)));
  EXPECT_FALSE(log.add(freeAt(0.002, 0.0029)));
  EXPECT_TRUE(log.add(freeAt(0.004, 0.0031)));
  EXPECT_TRUE(log.add(contactAt(0.006, 0.0032, 1)));
  EXPECT_FALSE(log.add(contactAt(0.008, 0.0032, 1)));
  EXPECT_TRUE(log.add(lineAt(0.010, 0.0032, 1)));
  EXPECT_TRUE(log.add(freeAt(0.012, 0.0032)));
  ContactObservation unsure = freeAt(0.014, 0.5);
  unsure.state = ContactState::kUnsure;
  EXPECT_FALSE(log.add(unsure));
  EXPECT_EQ(log.size(), 5U);
  EXPECT_EQ(log.from(3).size(), 2U);
  EXPECT_TRUE(log.from(6).empty());
}

TEST(EvidenceLog, TurningOnTheSpotIsNew) {
  EvidenceLog log({0.003, 0.01});
  log.add(freeAt(0.0, 0.0));
  ContactObservation turned = freeAt(0.1, 0.0);
  turned.T_world_object = makePose(Vec3::Zero(), {0.0, 0.0, 0.02});
  EXPECT_TRUE(log.add(turned));
}

TEST(MapKeeper, HoldsEveryObservationUpToTheStampWaitedFor) {
  MapKeeper keeper(emptyMaps(MethodKind::kPaper), {0.003, 0.01});
  for (int i = 0; i < 1000; ++i) keeper.push(freeAt(0.002 * i, 0.0002 * i));
  keeper.push(lineAt(3.0, 0.2, 1));
  ASSERT_TRUE(keeper.waitFor(3.0, kLongEnough));
  keeper.access([](const MapState& state) {
    EXPECT_DOUBLE_EQ(state.stamp, 3.0);
    EXPECT_EQ(state.lines.size(), 1U);
    EXPECT_GT(state.maps->world().size(), 0U);
    EXPECT_GT(state.maps->revision(), 0U);
  });
  EXPECT_FALSE(keeper.waitFor(3.1, 0.01)) << "what never came cannot be in the maps";
}

TEST(MapKeeper, ResetForgetsMapsAndEvidence) {
  MapKeeper keeper(emptyMaps(MethodKind::kPaper), {0.003, 0.01});
  keeper.push(lineAt(1.0, 0.0, 1));
  ASSERT_TRUE(keeper.waitFor(1.0, kLongEnough));
  keeper.reset();
  keeper.access([](const MapState& state) {
    EXPECT_EQ(state.maps->world().size(), 0U);
    EXPECT_EQ(state.log.size(), 0U);
    EXPECT_TRUE(state.lines.empty());
  });
}

class Replica : public testing::TestWithParam<MethodKind> {
 protected:
  EvidencePart partFrom(std::uint64_t first) const {
    EvidencePart part;
    keeper_.access([&](const MapState& state) {
      part = {state.log.epoch(), state.priors, first, state.log.from(first), changesOf(state)};
    });
    return part;
  }

  void feed(double begin, double x, int id) {
    for (int i = 0; i < 20; ++i) keeper_.push(freeAt(begin + 0.1 * i, x + 0.01 * i));
    keeper_.push(lineAt(begin + 3.0, x + 0.2, id));
    ASSERT_TRUE(keeper_.waitFor(begin + 3.0, kLongEnough));
  }

  MapKeeper keeper_{emptyMaps(GetParam()), {0.003, 0.01}};
  MethodReplica replica_{GetParam(), plainScenario(), 1};
};

TEST_P(Replica, FollowsTheMappingPartByPart) {
  feed(0.0, 0.0, 1);
  ASSERT_TRUE(replica_.extend(partFrom(replica_.size())));
  feed(10.0, -0.1, 2);
  ASSERT_TRUE(replica_.extend(partFrom(replica_.size())));
  EXPECT_EQ(replica_.size(), partFrom(0).observations.size());
  const Result<Plan> plan = replica_.plan(Pose::Identity(), plainScenario().goal);
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_FALSE(plan->tree.empty());
  const std::vector<double> risks = replica_.risksAlong(plan->path);
  ASSERT_EQ(risks.size(), plan->path.size());
  for (size_t i = 1; i < risks.size(); ++i) EXPECT_GE(risks[i], risks[i - 1]);
}

TEST_P(Replica, BeginsAnewAfterAResetOfTheMapping) {
  feed(0.0, 0.0, 1);
  ASSERT_TRUE(replica_.extend(partFrom(0)));
  keeper_.reset();
  feed(10.0, -0.1, 2);
  const EvidencePart all = partFrom(0);
  ASSERT_TRUE(replica_.extend(all));
  EXPECT_EQ(replica_.size(), all.observations.size());
}

TEST_P(Replica, KnowsWhatTheMappingIsTold) {
  if (GetParam() != MethodKind::kSmore) return;  // the others cannot be told anything
  feed(0.0, 0.0, 1);
  ASSERT_TRUE(replica_.extend(partFrom(0)));
  Prior in_hand{VoxelGrid(0.03), 0.999};
  Prior ahead = in_hand;
  for (std::int16_t y = -10; y < 10; ++y) {
    in_hand.known.set({-5, y, 0}, 1.0F);
    ahead.known.set({5, y, 0}, 1.0F);
  }
  const Pose touching = makePose({0.3, 0.0, 0.0});
  const double before = replica_.knowledge().assess(touching).risk;
  const PoseKnowledge untold = replica_.knowledge();
  keeper_.know(MapSide::kWorld, ahead);
  keeper_.know(MapSide::kObject, in_hand);
  ASSERT_TRUE(replica_.extend(partFrom(0)));
  EXPECT_EQ(untold.assess(touching).risk, before) << "it stays as it was";
  EXPECT_GT(replica_.knowledge().object.keys.size(), untold.object.keys.size());
  EXPECT_GT(replica_.knowledge().assess(touching).risk, std::max(before, 0.9));
  EXPECT_LT(replica_.knowledge().assess(Pose::Identity()).risk, 0.1);
}

TEST_P(Replica, RefusesPartsThatLeaveAGapOrDoNotMakeTheSameMaps) {
  feed(0.0, 0.0, 1);
  EvidencePart part = partFrom(2);
  EXPECT_FALSE(replica_.extend(part));
  part = partFrom(0);
  ++part.changes;
  if (GetParam() == MethodKind::kCspace) return;  // it learns no maps that could differ
  EXPECT_FALSE(replica_.extend(part));
  EXPECT_EQ(replica_.size(), 0U) << "it must ask for everything again";
  EXPECT_TRUE(replica_.extend(partFrom(0)));
}

TEST_P(Replica, AssessesPosesByTheWorkspace) {
  EXPECT_TRUE(replica_.knowledge().assess(Pose::Identity()).valid);
  EXPECT_FALSE(replica_.knowledge().assess(makePose({3.0, 0.0, 0.0})).valid);
}

INSTANTIATE_TEST_SUITE_P(Methods, Replica,
                         testing::Values(MethodKind::kPaper, MethodKind::kCspace,
                                         MethodKind::kSmore),
                         [](const auto& method) { return methodName(method.param); });

}  // namespace
}  // namespace smore
