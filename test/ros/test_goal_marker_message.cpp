// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "smore/ros/conversions.h"
#include "smore/ros/goal_marker_message.h"

namespace smore {
namespace {

using Control = visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarker;

MarkedGoal bar() {
  MarkedGoal goal;
  goal.T_world_goal = makePose({1.0, 2.0, 0.5}, {0.0, 0.0, 0.7});
  goal.object.voxel_size = 0.1;
  for (std::int16_t y = -3; y < 3; ++y) goal.object.keys.push_back({0, y, 0});
  goal.assessment = {true, 0.25, ""};
  return goal;
}

InteractiveMarker messageOf(const MarkedGoal& goal, Motion motion = Motion::kPlanar) {
  return goalMarkerMessage(goal, motion, "world");
}

Control controlOf(const InteractiveMarker& marker, const std::string& name) {
  for (const Control& control : marker.controls) {
    if (control.name == name) return control;
  }
  ADD_FAILURE() << "no control " << name;
  return Control();
}

/// What a control moves along, about or across: the x axis that it has turned.
Vec3 axisOf(const Control& control) {
  const auto& turn = control.orientation;
  const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
  EXPECT_NEAR(rotation.norm(), 1.0, 1e-9);
  return rotation * Vec3::UnitX();
}

TEST(GoalMarkerMessage, StandsAtTheGoalAsTheVoxelsOfTheObject) {
  const InteractiveMarker marker = messageOf(bar());
  EXPECT_EQ(marker.header.frame_id, "world");
  EXPECT_TRUE(marker.header.stamp.isZero());
  const Result<Pose> pose = fromMessage(marker.pose);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->isApprox(bar().T_world_goal, 1e-9));
  const auto body = controlOf(marker, "object").markers.at(0);
  EXPECT_EQ(body.type, visualization_msgs::Marker::CUBE_LIST);
  EXPECT_DOUBLE_EQ(body.scale.y, 0.1);
  ASSERT_EQ(body.points.size(), 6U);
  EXPECT_NEAR(body.points.front().y, -0.25, 1e-9);
  EXPECT_GT(marker.scale, 0.6) << "its handles lie outside of it";
}

TEST(GoalMarkerMessage, MovesInThePlaneOfPlanarMotion) {
  const InteractiveMarker marker = messageOf(bar());
  const Control object = controlOf(marker, "object");
  EXPECT_EQ(object.interaction_mode, Control::MOVE_PLANE);
  EXPECT_TRUE(axisOf(object).isApprox(Vec3::UnitZ(), 1e-9));
  const Control ring = controlOf(marker, "about z");
  EXPECT_EQ(ring.interaction_mode, Control::ROTATE_AXIS);
  EXPECT_TRUE(axisOf(ring).isApprox(Vec3::UnitZ(), 1e-9));
  EXPECT_EQ(marker.controls.size(), 3U) << "with its text, nothing else";
}

TEST(GoalMarkerMessage, MovesAlongAndAboutThreeAxesInSpace) {
  const InteractiveMarker marker = messageOf(bar(), Motion::kSpatial);
  std::set<std::pair<int, int>> moves;  // mode and axis
  for (const Control& control : marker.controls) {
    if (control.name == "text" || control.name == "object") continue;
    int axis = 0;
    EXPECT_NEAR(axisOf(control).cwiseAbs().maxCoeff(&axis), 1.0, 1e-9);
    moves.insert({control.interaction_mode, axis});
  }
  EXPECT_EQ(moves.size(), 6U);
}

TEST(GoalMarkerMessage, SaysTheRiskAndTheWayAboveTheGoalHoweverThatIsTurned) {
  MarkedGoal goal = bar();
  goal.way = "the way touches with probability 0.50";
  goal.T_world_goal = makePose({1.0, 2.0, 0.5}, {3.0, 0.4, 0.7});
  const auto text = controlOf(messageOf(goal, Motion::kSpatial), "text").markers.at(0);
  EXPECT_EQ(text.text, "touches here with probability 0.25\nthe way touches with probability 0.50");
  const Vec3 above = goal.T_world_goal.linear() *
                     Vec3(text.pose.position.x, text.pose.position.y, text.pose.position.z);
  EXPECT_NEAR(above.head<2>().norm(), 0.0, 1e-9);
  EXPECT_GT(above.z(), 0.3);
}

TEST(GoalMarkerMessage, HasColoursOfItsOwnForMoreRiskAndForWhatIsNotAllowed) {
  const auto color_of = [](const MarkedGoal& goal) {
    return controlOf(messageOf(goal), "object").markers.at(0).color;
  };
  MarkedGoal goal = bar();
  goal.assessment.risk = 0.0;
  const auto free = color_of(goal);
  goal.assessment.risk = 1.0;
  const auto touching = color_of(goal);
  goal.assessment = {false, 0.0, "the object lies outside"};
  const auto refused = color_of(goal);
  EXPECT_GT(free.g - touching.g, 0.5) << "light and dark, for the colour-blind";
  EXPECT_GT(refused.r - free.r, 0.5);
  EXPECT_EQ(controlOf(messageOf(goal), "text").markers.at(0).text,
            "not allowed: the object lies outside");
}

TEST(GoalMarkerMessage, CanBeTakenHoldOfBeforeAnythingIsKnownOfTheObject) {
  MarkedGoal goal = bar();
  goal.object.keys.clear();
  const InteractiveMarker marker = messageOf(goal);
  const auto body = controlOf(marker, "object").markers.at(0);
  EXPECT_EQ(body.type, visualization_msgs::Marker::SPHERE);
  EXPECT_GT(marker.scale, 0.1);
  EXPECT_NE(controlOf(marker, "text").markers.at(0).text.find("nothing is known"),
            std::string::npos);
}

}  // namespace
}  // namespace smore
