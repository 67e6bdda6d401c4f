// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "smore/common/robot.h"

namespace smore {

/// A robot whose motions end as a script says; when the script is used up, they reach their end.
class ScriptedRobot : public Robot {
 public:
  std::deque<MotionResult> script;
  std::vector<std::string> calls;
  MotionEnd reset_end = MotionEnd::kReached;
  double miss = 0.0;  ///< how far beside a path's end it stops where it says to have reached it [m]

  Pose pose() const override { return pose_; }

  MotionResult follow(const Path& path) override {
    calls.emplace_back("follow");
    MotionResult result;
    if (!script.empty()) {
      result = script.front();
      script.pop_front();
    }
    if (result.end == MotionEnd::kUnreachable) return result;
    result.length = pathLength(path);
    // A contact stops it half way along the first segment.
    pose_ = result.end == MotionEnd::kReached ? makePose(Vec3(miss, 0, 0)) * path.back()
                                              : interpolate(path[0], path[1], 0.5);
    return result;
  }

  MotionResult retreat(double /*distance*/) override {
    calls.emplace_back("retreat");
    return {};
  }

  MotionResult reset(const Pose& start) override {
    calls.emplace_back("reset");
    pose_ = start;
    MotionResult result;
    result.end = reset_end;
    result.reason = "stuck";
    return result;
  }

 private:
  Pose pose_ = Pose::Identity();
};

}  // namespace smore
