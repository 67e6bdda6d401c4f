// SPDX-License-Identifier: BSD-3-Clause
#include <console_bridge/console.h>
#include <gtest/gtest.h>

#include <string>

#include "smore/ros/robot_frames.h"
#include "smore/ros/wrist_poses.h"

namespace smore {
namespace {

/// Counts what tf2 says on its own.
class CountedLines : public console_bridge::OutputHandler {
 public:
  CountedLines() { console_bridge::useOutputHandler(this); }
  ~CountedLines() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& /*text*/, console_bridge::LogLevel /*level*/, const char* /*file*/,
           int /*line*/) override {
    ++count;
  }
  int count = 0;
};

class WristPosesTest : public ::testing::Test {
 protected:
  std::string add(const std::string& parent, const std::string& child, double time) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(
        stampedTransform(parent, child, makePose(Vec3(1, 2, 3), Vec3::Zero()), ros::Time(time)));
    return poses_.add(message, false);
  }

  Result<WrenchSample> sampleIn(const std::string& frame, double time) {
    geometry_msgs::WrenchStamped wrench;
    wrench.header.frame_id = frame;
    wrench.header.stamp = ros::Time(time);
    wrench.wrench.force.x = 5.0;
    return poses_.sampleOf(wrench);
  }

  CountedLines lines_;
  WristPoses poses_{FrameNames()};
};

TEST_F(WristPosesTest, giveTheWrenchInTheObjectFrameWithItsPose) {
  EXPECT_EQ(add("world", "object", 1.0), "");
  EXPECT_EQ(add("object", "sensor", 1.0), "");
  const Result<WrenchSample> sample = sampleIn("sensor", 1.0);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->sensor_object, Vec3(1, 2, 3));
  EXPECT_EQ(sample->wrench.torque, Vec3(1, 2, 3).cross(Vec3(5, 0, 0)));
  EXPECT_EQ(Vec3(sample->T_world_object.translation()), Vec3(1, 2, 3));
}

TEST_F(WristPosesTest, areTheSameToTheBitOnceNewerOnesAreThere) {
  const auto turn_to = [&](double angle, double time) {
    tf2_msgs::TFMessage message;
    const Pose pose = makePose(Vec3(0.1 * angle, 0.3, 0.7), Vec3(0.3 * angle, -0.7 * angle, angle));
    message.transforms.push_back(stampedTransform("world", "object", pose, ros::Time(time)));
    ASSERT_EQ(poses_.add(message, false), "");
  };
  for (int i = 1; i <= 1000; ++i) {
    turn_to(0.001 * i, 1.0 + i);
    const Result<WrenchSample> newest = sampleIn("object", 1.0 + i);
    turn_to(0.0010001 * i, 1.5 + i);
    const Result<WrenchSample> later = sampleIn("object", 1.0 + i);
    ASSERT_TRUE(newest && later);
    EXPECT_EQ(newest->T_world_object.matrix(), later->T_world_object.matrix()) << i;
  }
}

TEST_F(WristPosesTest, leaveOutWhatIsSentAgainAndSaySoInOneText) {
  EXPECT_EQ(add("world", "object", 2.0), "");
  for (const double time : {2.0, 1.5, 2.0}) {
    EXPECT_NE(add("world", "object", time).find("not newer"), std::string::npos);
  }
  EXPECT_EQ(add("world", "object", 2.1), "");
  EXPECT_TRUE(sampleIn("object", 2.05));
  EXPECT_EQ(lines_.count, 0) << "tf2 must not be made to complain about each";
}

TEST_F(WristPosesTest, refuseFramesThatTfCannotKnow) {
  for (const std::string& name : {std::string(), std::string("/object")}) {
    EXPECT_NE(frameNameProblem(name), "");
    EXPECT_NE(add("world", name, 1.0), "");
    EXPECT_NE(add(name, "object", 1.0), "");
  }
  EXPECT_EQ(frameNameProblem("tool0_controller"), "");
  EXPECT_EQ(lines_.count, 0);
}

// Time that goes back in one of these, be the object's own frame fixed to it, goes back for all.
TEST_F(WristPosesTest, knowWhatCarriesTheObject) {
  add("world", "base", 1.0);
  add("base", "tool", 1.0);
  add("world", "camera", 1.0);
  tf2_msgs::TFMessage fixed;
  fixed.transforms.push_back(stampedTransform("tool", "object", Pose::Identity(), ros::Time()));
  ASSERT_EQ(poses_.add(fixed, true), "");
  for (const char* frame : {"object", "tool", "base"}) EXPECT_TRUE(poses_.carriesObject(frame));
  EXPECT_FALSE(poses_.carriesObject("camera"));
  EXPECT_FALSE(poses_.carriesObject("nowhere"));
}

TEST_F(WristPosesTest, nameTheFrameThatIsUnknown) {
  add("world", "object", 1.0);
  const Result<WrenchSample> sample = sampleIn("nowhere", 1.0);
  ASSERT_FALSE(sample);
  EXPECT_NE(sample.reason().find("'nowhere' in 'object'"), std::string::npos) << sample.reason();
}

TEST_F(WristPosesTest, forgiveAWrenchThatCameJustBeforeTheFirstPose) {
  add("world", "object", 1.0);
  EXPECT_TRUE(poses_.begunAfter(ros::Time(0.9), 0.5));
  EXPECT_FALSE(poses_.begunAfter(ros::Time(0.4), 0.5));
  EXPECT_FALSE(poses_.begunAfter(ros::Time(1.1), 0.5));
}

}  // namespace
}  // namespace smore
