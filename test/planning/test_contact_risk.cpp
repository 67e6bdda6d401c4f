// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "known_boxes.h"
#include "smore/mapping/joint_belief.h"
#include "smore/planning/contact_risk.h"

namespace smore {
namespace {

// A belief with a few contacts in random directions, in the plane or in space.
JointBelief randomBelief(bool planar, unsigned seed) {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  if (planar) parameters.T_world_plane = Pose::Identity();
  parameters.seed = seed;
  JointBelief belief(parameters);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 5; ++k) {
    const double z = planar ? 0.0 : 1.0;
    ContactObservation observation;
    observation.state = ContactState::kContact;
    observation.T_world_object =
        makePose(0.2 * Vec3(uniform(random), uniform(random), z * uniform(random)),
                 {z * uniform(random), z * uniform(random), uniform(random)});
    LineOfAction line;
    line.direction = Vec3(uniform(random), uniform(random), z * uniform(random)).normalized();
    const Vec3 place = 0.3 * Vec3(uniform(random), uniform(random), z * uniform(random));
    line.point = place - place.dot(line.direction) * line.direction;
    observation.line = line;
    belief.observe(observation);
  }
  return belief;
}

JointBelief emptyBelief() {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  return JointBelief(parameters);
}

// Worlds in which two balls' centres are nearer than `distance`, by looking at all pairs.
HypothesisMask bruteForce(const SampledWorlds& worlds, const Pose& pose, double distance) {
  const Eigen::Isometry3f T = pose.cast<float>();
  HypothesisMask mask = 0;
  const WorldsAtUnit& at_unit = worlds.parts().front();
  for (const MaskedPoint& on_object : at_unit.object()) {
    const Eigen::Vector3f place = T * on_object.point;
    for (const MaskedPoint& in_world : at_unit.world()) {
      if ((place - in_world.point).squaredNorm() < distance * distance) {
        mask |= on_object.mask & in_world.mask;
      }
    }
  }
  return mask;
}

void compareWithAllPairs(bool planar) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int touching = 0;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const JointBelief belief = randomBelief(planar, seed);
    const ContactRisk risk(belief.worlds());
    const double distance = risk.worlds().sampled.contactDistance();
    // Half the diagonal of the cells in which the fast look-up answers; in space they are coarser.
    const double rounding = (planar ? 0.2 : 0.5) * distance;
    for (int i = 0; i < (planar ? 30 : 6); ++i) {
      const double z = planar ? 0.0 : 1.0;
      const Pose pose = makePose(0.4 * Vec3(uniform(random), uniform(random), z * uniform(random)),
                                 {z * uniform(random), z * uniform(random), 3.0 * uniform(random)});
      const HypothesisMask mask = risk.touching(pose);
      const HypothesisMask certainly = bruteForce(risk.worlds().sampled, pose, distance - rounding);
      const HypothesisMask perhaps = bruteForce(risk.worlds().sampled, pose, distance + rounding);
      EXPECT_EQ(certainly & ~mask, 0U);
      EXPECT_EQ(mask & ~perhaps, 0U);
      EXPECT_DOUBLE_EQ(risk.atPose(pose), SampledWorlds::shareOf(mask));
      touching += mask != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 3);
}

TEST(ContactRisk, AgreesWithAllPairsInThePlane) { compareWithAllPairs(true); }

TEST(ContactRisk, AgreesWithAllPairsInSpace) { compareWithAllPairs(false); }

TEST(ContactRisk, AlongAPathIsTheUnionOverItsPosesNotTheirSum) {
  const JointBelief belief = randomBelief(true, 2);
  const ContactRisk risk(belief.worlds());
  const Path path = {makePose({-0.3, 0, 0}), makePose({0.3, 0.1, 0}, {0, 0, 0.5})};
  HypothesisMask mask = 0;
  for (const Pose& pose : densify(path, 0.001, 0.002)) mask |= risk.touching(pose);
  // The coarser check may miss a graze between two of its poses.
  EXPECT_NEAR(risk.along(path), SampledWorlds::shareOf(mask), 0.05);
  EXPECT_GT(risk.along(path), 0.0);
  EXPECT_GE(risk.along(path), risk.atPose(path.front()));
}

// An arm is never quite in the plane of motion: what touched there touches there.
TEST(ContactRisk, InThePlaneDoesNotFallWithTheHeightAboveIt) {
  const Pose T_world_plane = makePose({0.1, 0.2, 0.3}, {0.4, 0.2, 0.1});
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  parameters.T_world_plane = T_world_plane;
  for (const Pose& off : {Pose(Pose::Identity()), makePose({0, 0, 0.008}),
                          makePose({0, 0, -0.02}, {0.05, -0.03, 0})}) {
    JointBelief belief(parameters);
    ContactObservation observation;
    observation.state = ContactState::kFree;
    for (double x = 0.2; x < 0.29; x += 0.01) {
      observation.T_world_object = T_world_plane * makePose({x, 0, 0}) * off;
      belief.observe(observation);
    }
    observation.state = ContactState::kContact;
    observation.T_world_object = T_world_plane * makePose({0.3, 0, 0}) * off;
    observation.line = LineOfAction{Vec3::Zero(), -Vec3::UnitX(), 6.0};
    belief.observe(observation);
    const ContactRisk risk(belief.worlds());
    const Pose on = T_world_plane * makePose({0.3 + 2.0 * risk.worlds().feature.tolerance, 0, 0});
    EXPECT_GT(risk.atPose(on * off), 0.9);
    EXPECT_GT(risk.atPose(on), 0.9);
    EXPECT_TRUE(risk.worlds().free.knows(belief.toMap(T_world_plane * makePose({0.25, 0, 0}))));
  }
}

TEST(ContactRisk, NothingKnownIsNoRisk) {
  const JointBelief belief = emptyBelief();
  const ContactRisk risk(belief.worlds());
  EXPECT_EQ(risk.atPose(Pose::Identity()), 0.0);
  EXPECT_EQ(risk.along({makePose({0, 0, 0}), makePose({1, 0, 0})}), 0.0);
}

// As many new cells as there are known ones: whether the next surprise comes before or after is
// even, whatever the scale.
TEST(ContactRisk, OfAMotionFallsWithWhatIsKnownToBeFree) {
  JointBelief belief = emptyBelief();
  const double cell = belief.worlds()->free.parameters().position_cell;
  ContactObservation free;
  free.state = ContactState::kFree;
  constexpr int kCells = 40;
  for (int i = 0; i < kCells; ++i) {
    free.T_world_object = makePose({i * cell, 0, 0});
    belief.observe(free);
  }
  const ContactRisk risk(belief.worlds());
  const auto motion = [&](int from, int to) {
    return Path{makePose({from * cell, 0, 0}), makePose({to * cell, 0, 0})};
  };
  EXPECT_LT(risk.ofMotion(motion(0, kCells - 1)), 0.01);
  EXPECT_NEAR(risk.ofMotion(motion(0, 2 * kCells - 1)), 0.5, 0.02);
  EXPECT_NEAR(risk.ofMotion(motion(0, 4 * kCells - 1)), 0.75, 0.02);
  Path there_and_back = motion(0, 2 * kCells - 1);
  there_and_back.push_back(there_and_back.front());
  EXPECT_DOUBLE_EQ(risk.ofMotion(there_and_back), risk.ofMotion(motion(0, 2 * kCells - 1)));
}

// Where all is known beforehand nothing can surprise: before anything has moved the risk is that of
// what is known.
TEST(ContactRisk, OfAMotionIsThatOfWhatIsKnownBeforehand) {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  parameters.T_world_plane = Pose::Identity();
  JointBelief belief(parameters);
  const Path clear = {makePose({0, 0, 0}), makePose({0.2, 0, 0})};
  const Path blocked = {makePose({0, 0, 0}), makePose({0.4, 0, 0})};
  EXPECT_GT(ContactRisk(belief.worlds()).ofMotion(clear), 0.9);
  belief.know(MapSide::kObject, barKnown());
  const double object_known = ContactRisk(belief.worlds()).ofMotion(clear);
  EXPECT_GT(object_known, 0.5);
  belief.know(MapSide::kWorld, boxKnown({0.5, -1.0, -0.1}, {1.5, 1.0, 0.1}, 1.0));
  EXPECT_LT(ContactRisk(belief.worlds()).ofMotion(clear), 0.02);
  EXPECT_GT(ContactRisk(belief.worlds()).ofMotion(blocked), 0.95);
}

// A rod of 2 m, much longer than things of this unit, is turned past a thin post at its end: on a
// turn that looks at every pose of a thing of the usual reach it would jump over the post.
TEST(ContactRisk, OfATurnCountsTheEndOfALongKnownRod) {
  JointBeliefParameters parameters;
  parameters.unit = 0.05;
  parameters.T_world_plane = Pose::Identity();
  JointBelief belief(parameters);
  belief.know(MapSide::kObject, boxKnown({0.0, 0.0, -0.1}, {2.0, 0.01, 0.1}, 0.05));
  belief.know(MapSide::kWorld, boxKnown({1.93, 0.0, -0.1}, {1.95, 0.01, 0.1}, 0.05));
  const ContactRisk risk(belief.worlds());
  for (double from = 0.05; from < 0.1; from += 0.003) {
    const Path turn = {makePose(Vec3::Zero(), Vec3(0, 0, from)),
                       makePose(Vec3::Zero(), Vec3(0, 0, -from))};
    EXPECT_GT(risk.along(turn), 0.9) << from;
  }
}

// Of a motion through known free space the outcome depends on the sampled worlds alone: their
// entropy, counted world by world.
TEST(ContactRisk, InformationIsTheEntropyOfWhereEachWorldTouchesFirst) {
  JointBelief belief = randomBelief(true, 2);
  const Path path = {makePose({-0.3, 0, 0}), makePose({0.3, 0.1, 0})};
  const FreeSpaceParameters cell = belief.worlds()->free.parameters();
  Path poses = densify(path, 0.5 * cell.position_cell, cell.angle_cell);
  for (Pose& pose : poses) pose = FreeCells(kPoseAccuracy).centerOf(pose);
  ContactObservation free;
  free.state = ContactState::kFree;
  // Known to be free but for the half that the worlds are asked about.
  for (std::size_t i = 0; i < poses.size() / 2; ++i) {
    free.T_world_object = poses[i];
    belief.observe(free);
  }
  const ContactRisk risk(belief.worlds());
  const Path known(poses.begin(), poses.begin() + static_cast<long>(poses.size() / 2));
  std::map<std::size_t, int> worlds_by_outcome;
  for (int world = 0; world < kHypotheses; ++world) {
    std::size_t outcome = 0;
    while (outcome < known.size() && (risk.touching(known[outcome]) >> world & 1U) == 0) ++outcome;
    ++worlds_by_outcome[outcome];
  }
  double entropy = 0.0;
  for (const auto& [outcome, worlds] : worlds_by_outcome) {
    const double share = static_cast<double>(worlds) / kHypotheses;
    entropy -= share * std::log(share);
  }
  EXPECT_NEAR(risk.informationOf(known), entropy, 1e-9);
  EXPECT_GT(risk.informationOf(path), entropy) << "the rest may touch what nothing has touched yet";
}

// Where nothing is known the outcome is whether something unknown is touched, and with which place
// of the object's surface: with the probability of ofMotion, but for the worlds that it counts too.
TEST(ContactRisk, InformationAndRiskKnowOfOneSurprise) {
  JointBelief belief = emptyBelief();
  ContactObservation free;
  free.state = ContactState::kFree;
  const double cell = belief.worlds()->free.parameters().position_cell;
  for (int i = 0; i < 40; ++i) {
    free.T_world_object = makePose({i * cell, 0, 0});
    belief.observe(free);
  }
  const ContactRisk risk(belief.worlds());
  const FeatureParameters feature;
  const double patches = 4.0 * M_PI * std::pow(feature.reach / feature.conflictDistance(), 2);
  for (const int cells : {20, 60, 200}) {
    const Path motion = {makePose({0, 0, 0}), makePose({cells * cell, 0, 0})};
    const double surprise = 1.0 - (1.0 - risk.ofMotion(motion)) / (1.0 - risk.ofMotion({}));
    double expected = surprise * std::log(patches);
    for (const double p : {surprise, 1.0 - surprise}) expected -= p > 0.0 ? p * std::log(p) : 0.0;
    EXPECT_NEAR(risk.informationOf(motion), expected, 1e-9) << cells;
  }
}

}  // namespace
}  // namespace smore
