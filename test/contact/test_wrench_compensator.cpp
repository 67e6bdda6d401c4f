// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "payload_at.h"
#include "smore/contact/wrench_compensator.h"

namespace smore {
namespace {

WrenchSample sampleOf(const Wrench& wrench, const Pose& pose = Pose::Identity()) {
  return {0.0, wrench, pose};
}

TEST(WrenchCompensator, subtractsTheMeanOfTheStillSamples) {
  TareParameters parameters;
  parameters.samples = 4;
  WrenchCompensator compensator(parameters);
  for (const double offset : {-0.2, -0.1, 0.1, 0.2}) {
    EXPECT_FALSE(compensator.tared());
    EXPECT_FALSE(compensator.process(sampleOf({Vec3(1 + offset, 2, 3), Vec3(0.1, 0, 0)})));
  }
  ASSERT_TRUE(compensator.tared());
  const auto wrench = compensator.process(sampleOf({Vec3(6, 2, 3), Vec3(0.1, 0.5, 0)}));
  ASSERT_TRUE(wrench);
  EXPECT_TRUE(wrench->force.isApprox(Vec3(5, 0, 0), 1e-12));
  EXPECT_TRUE(wrench->torque.isApprox(Vec3(0, 0.5, 0), 1e-12));
}

TEST(WrenchCompensator, refusesAMovingRobotAndTriesAgain) {
  TareParameters parameters;
  parameters.samples = 10;
  parameters.max_force_stddev = 0.5;
  WrenchCompensator compensator(parameters);
  for (int i = 0; i < 10; ++i) compensator.process(sampleOf({Vec3(i, 0, 0), Vec3::Zero()}));
  EXPECT_FALSE(compensator.tared());
  EXPECT_NE(compensator.tareProblem().find("not still"), std::string::npos);
  for (int i = 0; i < 10; ++i) compensator.process(sampleOf({Vec3(7, 0, 0), Vec3::Zero()}));
  EXPECT_TRUE(compensator.tared());
  EXPECT_TRUE(compensator.tareProblem().empty());
}

class PayloadOf : public ::testing::TestWithParam<Payload> {};

TEST_P(PayloadOf, itsWeightIsTakenOffInEveryPose) {
  const Payload payload = GetParam();
  TareParameters parameters;
  parameters.samples = 2;
  WrenchCompensator compensator(parameters, payload);
  const Wrench bias{Vec3(1, -2, 3), Vec3(0.1, 0.2, -0.3)};
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  for (int i = 0; i < 100; ++i) {
    const Pose pose = makePose(Vec3::Zero(), Vec3(angle(random), angle(random), angle(random)));
    const Vec3 gravity = pose.linear().transpose() * Vec3(0, 0, -9.80665);
    const Wrench contact{Vec3(4, 5, 6), Vec3(0.4, 0.5, 0.6)};
    const bool taring = i < 2;
    Wrench raw{bias.force + payload.mass * gravity,
               bias.torque + payload.moment_object.cross(gravity)};
    if (!taring) raw = {raw.force + contact.force, raw.torque + contact.torque};
    const auto wrench = compensator.process(sampleOf(raw, pose));
    ASSERT_EQ(wrench.has_value(), !taring);
    if (taring) continue;
    EXPECT_TRUE(wrench->force.isApprox(contact.force, 1e-9));
    EXPECT_TRUE(wrench->torque.isApprox(contact.torque, 1e-9));
  }
}

INSTANTIATE_TEST_SUITE_P(Masses, PayloadOf,
                         ::testing::Values(payloadAt(1.2, Vec3(0.05, -0.02, 0.1)),
                                           Payload{0.0, Vec3(0.03, -0.02, 0.05)},
                                           Payload{-0.2, Vec3(-0.02, 0.01, -0.03)}));

}  // namespace
}  // namespace smore
