// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "smore/planning/contact_risk.h"

namespace smore {
namespace {

// A belief with a few contacts in random directions, in the plane or in space.
JointBelief randomBelief(bool planar, unsigned seed) {
  JointBeliefParameters parameters;
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

// Worlds in which two balls' centres are nearer than `distance`, by looking at all pairs.
HypothesisMask bruteForce(const SampledWorlds& worlds, const Pose& pose, double distance) {
  const Eigen::Isometry3f T = pose.cast<float>();
  HypothesisMask mask = 0;
  for (const MaskedPoint& on_object : worlds.object()) {
    const Eigen::Vector3f place = T * on_object.point;
    for (const MaskedPoint& in_world : worlds.world()) {
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
    const ContactRisk risk(belief);
    const double distance = risk.worlds().contactDistance();
    // Half the diagonal of the cells in which the fast look-up answers; in space they are coarser.
    const double rounding = (planar ? 0.2 : 0.5) * distance;
    for (int i = 0; i < (planar ? 30 : 6); ++i) {
      const double z = planar ? 0.0 : 1.0;
      const Pose pose = makePose(0.4 * Vec3(uniform(random), uniform(random), z * uniform(random)),
                                 {z * uniform(random), z * uniform(random), 3.0 * uniform(random)});
      const HypothesisMask mask = risk.touching(pose);
      const HypothesisMask certainly = bruteForce(risk.worlds(), pose, distance - rounding);
      const HypothesisMask perhaps = bruteForce(risk.worlds(), pose, distance + rounding);
      EXPECT_EQ(certainly & ~mask, 0U);
      EXPECT_EQ(mask & ~perhaps, 0U);
      EXPECT_DOUBLE_EQ(risk.atPose(pose), shareOf(mask));
      touching += mask != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 3);
}

TEST(ContactRisk, AgreesWithAllPairsInThePlane) { compareWithAllPairs(true); }

TEST(ContactRisk, AgreesWithAllPairsInSpace) { compareWithAllPairs(false); }

TEST(ContactRisk, AlongAPathIsTheUnionOverItsPosesNotTheirSum) {
  const JointBelief belief = randomBelief(true, 2);
  const ContactRisk risk(belief);
  const Path path = {makePose({-0.3, 0, 0}), makePose({0.3, 0.1, 0}, {0, 0, 0.5})};
  HypothesisMask mask = 0;
  for (const Pose& pose : densify(path, 0.001, 0.002)) mask |= risk.touching(pose);
  // The coarser check may miss a graze between two of its poses.
  EXPECT_NEAR(risk.along(path), shareOf(mask), 0.05);
  EXPECT_GT(risk.along(path), 0.0);
  EXPECT_GE(risk.along(path), risk.atPose(path.front()));
}

TEST(ContactRisk, NothingKnownIsNoRisk) {
  const JointBelief belief{JointBeliefParameters{}};
  const ContactRisk risk(belief);
  EXPECT_EQ(risk.atPose(Pose::Identity()), 0.0);
  EXPECT_EQ(risk.along({makePose({0, 0, 0}), makePose({1, 0, 0})}), 0.0);
}

}  // namespace
}  // namespace smore
