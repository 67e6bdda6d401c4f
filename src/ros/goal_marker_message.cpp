// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/goal_marker_message.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>

#include "smore/ros/conversions.h"
#include "smore/ros/marker_parts.h"

namespace smore {
namespace {

using Control = visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::Marker;

// Choices for the eye.
constexpr double kUnknownReach = 4.0;     // of an object that nothing is known of [voxels]
constexpr double kControlsByReach = 2.2;  // size of the controls over the object's reach
constexpr double kTextByControls = 0.05;  // height of a letter over the size of the controls
constexpr double kTextAbove = 0.5;        // of the goal, over the size of the controls
constexpr float kOpacity = 0.8F;

double reachOf(const OccupiedVoxels& object) {
  double reach = object.keys.empty() ? kUnknownReach * object.voxel_size : 0.0;
  for (const Vec3& center : centersOf(object)) reach = std::max(reach, center.norm());
  return reach + object.voxel_size;
}

std::string textOf(const MarkedGoal& goal) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  if (goal.assessment.valid) {
    text << "touches here with probability " << goal.assessment.risk;
  } else {
    text << "not allowed: " << goal.assessment.problem;
  }
  if (goal.object.keys.empty()) text << "\nnothing is known of the object's shape";
  if (!goal.way.empty()) text << "\n" << goal.way;
  return text.str();
}

Marker bodyOf(const MarkedGoal& goal) {
  Marker body = makeMarker("", "", 0, Marker::CUBE_LIST);
  const double size = goal.object.voxel_size;
  body.scale = toScale(size, size, size);
  body.color =
      goal.assessment.valid ? riskColor(goal.assessment.risk, kOpacity) : refusedColor(kOpacity);
  for (const Vec3& center : centersOf(goal.object)) body.points.push_back(toPoint(center));
  if (body.points.empty()) body.type = Marker::SPHERE;
  return body;
}

/// Its text stands above it in the world, however the goal is turned.
Control textControl(const MarkedGoal& goal, double size) {
  Marker text = makeMarker("", "", 0, Marker::TEXT_VIEW_FACING);
  text.text = textOf(goal);
  text.scale.z = kTextByControls * size;
  text.color = makeColor(1.0F, 1.0F, 1.0F, 1.0F);
  const Vec3 above = goal.T_world_goal.linear().transpose() * Vec3(0.0, 0.0, kTextAbove * size);
  text.pose.position = toPoint(above);
  Control control;
  control.name = "text";
  control.orientation.w = 1.0;
  control.interaction_mode = Control::NONE;
  control.always_visible = static_cast<unsigned char>(true);
  control.markers.push_back(text);
  return control;
}

/// What moves along, about or across `axis`.
Control controlOf(const std::string& name, const Vec3& axis, int mode) {
  Control control;
  control.name = name;
  control.interaction_mode = static_cast<std::uint8_t>(mode);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), axis);
  control.orientation.w = turn.w();
  control.orientation.x = turn.x();
  control.orientation.y = turn.y();
  control.orientation.z = turn.z();
  return control;
}

Control bodyControl(const MarkedGoal& goal, Motion motion) {
  const bool planar = motion == Motion::kPlanar;
  Control control =
      controlOf("object", Vec3::UnitZ(), planar ? Control::MOVE_PLANE : Control::MENU);
  control.always_visible = static_cast<unsigned char>(true);
  control.markers.push_back(bodyOf(goal));
  return control;
}

void addAxes(InteractiveMarker* marker) {
  const std::tuple<const char*, const char*, Vec3> axes[] = {{"along x", "about x", Vec3::UnitX()},
                                                             {"along y", "about y", Vec3::UnitY()},
                                                             {"along z", "about z", Vec3::UnitZ()}};
  for (const auto& [along, about, axis] : axes) {
    marker->controls.push_back(controlOf(along, axis, Control::MOVE_AXIS));
    marker->controls.push_back(controlOf(about, axis, Control::ROTATE_AXIS));
  }
}

visualization_msgs::MenuEntry backEntry() {
  visualization_msgs::MenuEntry entry;
  entry.id = kBackToTheTasksGoal;
  entry.title = "Back to the task's goal";
  entry.command_type = visualization_msgs::MenuEntry::FEEDBACK;
  return entry;
}

}  // namespace

InteractiveMarker goalMarkerMessage(const MarkedGoal& goal, Motion motion,
                                    const std::string& world_frame) {
  InteractiveMarker marker;
  marker.header.frame_id = world_frame;
  marker.name = kGoalMarkerName;
  marker.pose = toMessage(goal.T_world_goal);
  const double size = kControlsByReach * reachOf(goal.object);
  marker.scale = static_cast<float>(size);
  marker.menu_entries.push_back(backEntry());
  marker.controls.push_back(bodyControl(goal, motion));
  marker.controls.push_back(textControl(goal, size));
  if (motion == Motion::kPlanar) {
    marker.controls.push_back(controlOf("about z", Vec3::UnitZ(), Control::ROTATE_AXIS));
  } else {
    addAxes(&marker);
  }
  return marker;
}

}  // namespace smore
