// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "belief_observations.h"
#include "smore/mapping/joint_belief.h"
#include "smore/mapping/repeated_touches.h"

namespace smore {
namespace {

TEST(RepeatedTouchesTest, posesCountThatHaveAnotherOneNearby) {
  const double tolerance = 0.008;
  const double reach = 0.5;
  const Pose alone = makePose({1, 0, 0});
  const Pose first = makePose({0, 0, 0});
  const Pose shifted = makePose({0.006, 0, 0}, {0, 0, 0.003});  // 6 mm and 1.5 mm
  const Pose turned = makePose({0.006, 0, 0}, {0, 0, 0.02});    // 6 mm and 10 mm
  EXPECT_TRUE(repeatedTouches({}, tolerance, reach).empty());
  EXPECT_TRUE(repeatedTouches({alone, first, turned}, tolerance, reach).empty());
  const auto repeated = repeatedTouches({first, alone, shifted}, tolerance, reach);
  ASSERT_EQ(repeated.size(), 2U);
  EXPECT_TRUE(repeated[0].isApprox(first));
  EXPECT_TRUE(repeated[1].isApprox(shifted));
}

// What touches is pushed aside: the force is square to the motion, and so is what explains it.
ContactObservation graze(int contact_id) {
  const Pose pose = makePose({0.3, 1e-4 * contact_id, 0});
  ContactObservation observation = contactAt(pose, {0.2, 0, 0}, {-0.02, -1, 0});
  observation.contact_id = contact_id;
  return observation;
}

TEST(RepeatedTouchesTest, aMotionThatTouchedTwiceIsNotExpectedToPassAThirdTime) {
  JointBelief belief(planarParameters());
  for (int i = 0; i < 30; ++i) belief.observe(freeAt(makePose({0.01 * i, 0, 0}), 0));
  const Eigen::Isometry3f there = makePose({0.3, 0, 0}).cast<float>();
  const Eigen::Isometry3f elsewhere = makePose({0.2, 0, 0}).cast<float>();
  belief.observe(graze(1));
  const double once = SampledWorlds::shareOf(belief.worlds()->sampled.touching(there));
  EXPECT_LT(once, 0.9);
  belief.observe(graze(2));
  const SampledWorlds& twice = belief.worlds()->sampled;
  EXPECT_NEAR(SampledWorlds::shareOf(twice.touching(there)), 1.0, 1e-9);
  EXPECT_LT(SampledWorlds::shareOf(twice.touching(elsewhere)), 0.2);
}

}  // namespace
}  // namespace smore
