// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/contact/line_of_action.h"
#include "smore/simulation/driver_wrench.h"

namespace smore {
namespace {

const Wrench kFelt{Vec3(3, -8, 2), Vec3(0.4, 0.1, -0.9)};

TEST(DriverWrench, isTheSensorsOwnWhereNothingIsSet) {
  DriverWrench driver({});
  const Wrench wrench = driver.at(0.0, kFelt, Pose::Identity());
  EXPECT_EQ(wrench.force, kFelt.force);
  EXPECT_EQ(wrench.torque, kFelt.torque);
}

// In the frame of the TCP the line ought to pass where it does; it lies 2p from there.
TEST(DriverWrench, putsLinesTwiceTheTcpOff) {
  const Vec3 tcp(0, 0, 0.1);
  DriverWrench driver({tcp, 0.0, Vec3::Zero()});
  const Vec3 force(0, 9, 0);
  const Vec3 touched(0.02, 0, 0.25);  // in the flange's frame
  const Wrench seen = driver.at(0.0, {force, touched.cross(force)}, Pose::Identity());
  const Vec3 believed = touched - tcp + 2.0 * tcp;  // in the frame of the TCP
  EXPECT_LT((believed.cross(force) - seen.torque).norm(), 1e-12);
}

TEST(DriverWrench, takesTheWeightOffInEveryPoseAndZeroesWhatIsLeft) {
  const Vec3 center(0.01, 0, 0.08);
  DriverWrench driver({Vec3::Zero(), 1.5, center});
  driver.askForZero(0.01);
  const Wrench bias{Vec3(2, -1, 3), Vec3(0.1, 0.2, 0)};
  for (const double roll : {0.0, 0.0, 0.7, 2.5}) {
    const Pose T_world_flange = makePose(Vec3(0.3, 0, 0.4), Vec3(roll, 0.2, 0));
    const Vec3 weight = T_world_flange.linear().transpose() * (1.5 * gravity());
    const Wrench felt{bias.force + weight, bias.torque + center.cross(weight)};
    const Wrench wrench = driver.at(0.02, felt, T_world_flange);
    EXPECT_LT(wrench.force.norm() + wrench.torque.norm(), 1e-12);
  }
}

}  // namespace
}  // namespace smore
