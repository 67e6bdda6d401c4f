// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "payload_at.h"
#include "smore/contact/payload_identification.h"

namespace smore {
namespace {

// Still wrenches of a sensor that is turned in the object, as a driver with such axes gives them.
std::vector<StillWrench> withDriversAxes(const WrenchAxes& axes, double noise) {
  std::mt19937 random(4);
  std::normal_distribution<double> error(0.0, noise);
  const Eigen::Matrix3d sensor_axes_object = makePose(Vec3::Zero(), Vec3(0.4, -0.7, 2.1)).linear();
  const Payload payload = payloadAt(1.2, Vec3(0.02, -0.01, 0.15));
  std::vector<StillWrench> poses;
  std::vector<Pose> stands = payloadTilts(Pose::Identity(), 0.5);
  stands.push_back(Pose::Identity());
  for (const Pose& stand : stands) {
    StillWrench still;
    still.T_world_object = stand;
    still.sensor_axes_object = sensor_axes_object;
    const Vec3 weight = payload.mass * gravityIn(still.T_world_object);
    const Wrench felt{weight + Vec3(3, -2, 5) + Vec3(error(random), error(random), error(random)),
                      payload.moment_object.cross(weight / payload.mass) + Vec3(0.3, 0.1, -0.2)};
    const Eigen::Matrix3d turn =
        axes.sign * sensor_axes_object * axes.turn.transpose() * sensor_axes_object.transpose();
    still.mean = {turn * felt.force, turn * felt.torque};
    poses.push_back(still);
  }
  return poses;
}

TEST(IdentifyPayload, namesTheSignAndTheAxesThatGravityTells) {
  for (const WrenchAxes& axes : allWrenchAxes()) {
    const auto found = identifyPayload(withDriversAxes(axes, 0.1));
    if (toText(axes) == toText(WrenchAxes())) {
      EXPECT_TRUE(found) << found.reason();
      continue;
    }
    ASSERT_FALSE(found) << toText(axes);
    EXPECT_NE(found.reason().find(toText(axes)), std::string::npos) << found.reason();
  }
}

TEST(IdentifyPayload, namesTheAxesAgainstThoseThatItWasTold) {
  const WrenchAxes told = allWrenchAxes()[7];
  const WrenchAxes wrong = allWrenchAxes()[30];
  const auto found = identifyPayload(withDriversAxes(wrong, 0.1), told);
  ASSERT_FALSE(found);
  EXPECT_NE(found.reason().find(toText(compose(wrong, told))), std::string::npos);
}

}  // namespace
}  // namespace smore
