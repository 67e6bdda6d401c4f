// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>

#include "smore/common/result.h"
#include "smore/contact/wrench_axes.h"

namespace smore {
namespace {

WrenchAxes read(const std::string& yaml) {
  ParameterReader reader(YAML::Load(yaml), "test");
  WrenchAxes axes = readWrenchAxes(&reader);
  reader.finish();
  return axes;
}

TEST(WrenchAxes, turnForceAndTorqueAlike) {
  const WrenchAxes axes = read("{wrench_sign: -1, wrench_axes: y -x z}");
  const Wrench wrench = inFrame(axes, {Vec3(1, 2, 3), Vec3(4, 5, 6)});
  EXPECT_EQ(wrench.force, Vec3(-2, 1, -3));
  EXPECT_EQ(wrench.torque, Vec3(-5, 4, -6));
}

// A turned frame has the same line of action; another sign reverses its force and leaves its place.
TEST(WrenchAxes, ofAnySignLeaveTheLineWhereItIs) {
  const Vec3 point(0.1, -0.2, 0.3), force(3, -4, 12);
  for (const WrenchAxes& axes : allWrenchAxes()) {
    const Wrench wrench = inFrame(axes, {force, point.cross(force)});
    EXPECT_LT(((axes.turn * point).cross(wrench.force) - wrench.torque).norm(), 1e-12);
  }
}

TEST(WrenchAxes, areTheTwentyFourTurnsWithEitherSignAndReadAsTheyAreWritten) {
  std::set<std::string> texts;
  for (const WrenchAxes& axes : allWrenchAxes()) {
    EXPECT_NEAR(axes.turn.determinant(), 1.0, 1e-12);
    texts.insert(toText(axes));
    const WrenchAxes again = read("{" + toText(axes) + "}");
    EXPECT_EQ(again.turn, axes.turn);
    EXPECT_EQ(again.sign, axes.sign);
  }
  EXPECT_EQ(texts.size(), 48U);
  EXPECT_EQ(toText(allWrenchAxes().front()), "wrench_sign: 1, wrench_axes: x y z");
}

TEST(WrenchAxes, composeAsTheyAreApplied) {
  const Wrench wrench{Vec3(1, 2, 3), Vec3(4, 5, 6)};
  const auto all = allWrenchAxes();
  const Wrench twice = inFrame(all[29], inFrame(all[11], wrench));
  EXPECT_EQ(inFrame(compose(all[29], all[11]), wrench).torque, twice.torque);
}

TEST(WrenchAxes, thatAreNoFrameAreTold) {
  for (const char* bad : {"x y", "x y z x", "x x z", "y x z", "-x -y -z", "a y z", "--x y z"}) {
    EXPECT_THROW(read(std::string("{wrench_sign: 1, wrench_axes: ") + bad + "}"), InputError)
        << bad;
  }
  EXPECT_THROW(read("{wrench_sign: 0, wrench_axes: x y z}"), InputError);
}

}  // namespace
}  // namespace smore
