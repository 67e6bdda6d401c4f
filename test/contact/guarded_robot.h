// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "smore/contact/motion_guard.h"

namespace smore {

constexpr double kPeriod = 0.002;  // of both streams [s]
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline const std::vector<std::string> kJoints = {"shoulder", "elbow"};

inline Wrench push(double force) { return {Vec3(0.0, force, 0.0), Vec3::Zero()}; }

/// A guard on a clock that only `run` moves.
class MotionGuardTest : public ::testing::Test {
 protected:
  void SetUp() override {
    run(0.01);
    ASSERT_EQ(guard_.fault(), "");
  }

  // Lets time pass with the streams that speak.
  void run(double duration, bool wrenches = true, bool joints = true, bool contacts = true) {
    const int samples = static_cast<int>(std::lround(duration / kPeriod));
    for (int i = 0; i < samples; ++i) {
      now_ += kPeriod;
      if (wrenches) guard_.onWrench(now_, now_, wrench_);
      if (joints) guard_.onJoints(now_, {now_, kJoints, positions_, velocities_});
      if (contacts) guard_.onContact(now_, now_, true);
      guard_.check(now_);
    }
  }

  // From where the joints are, the first by `step` [rad] within `time` [s].
  JointTrajectory motion(double step, double time) const {
    std::vector<double> end = positions_;
    end[0] += step;
    return {kJoints, {{0.0, positions_, {0.0, 0.0}}, {time, end, {0.0, 0.0}}}};
  }

  void expectRefused(const JointTrajectory& trajectory, const std::string& words) {
    EXPECT_FALSE(guard_.admit(now_, trajectory));
    EXPECT_NE(guard_.fault().find(words), std::string::npos) << guard_.fault();
    guard_.clear(now_);
  }

  MotionGuardParameters parameters_;
  MotionGuard guard_{parameters_, kJoints};
  double now_ = 100.0;
  Wrench wrench_;
  std::vector<double> positions_{0.3, -0.8};
  std::vector<double> velocities_{0.0, 0.0};
};

}  // namespace smore
