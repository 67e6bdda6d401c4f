// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/wrist_poses.h"

#include <cmath>
#include <sstream>

#include "smore/ros/names.h"

namespace smore {
namespace {

std::string describe(const geometry_msgs::TransformStamped& transform) {
  std::ostringstream text;
  text << "the transform of '" << transform.child_frame_id << "' in '" << transform.header.frame_id
       << "' at " << transform.header.stamp << " s";
  return text.str();
}

// Multiples of about 1e-9 (m, and of a quaternion's parts): far below what any robot knows, and far
// above the last bit, in which tf2 differs by whether it knows a newer pose by then. So the same
// wrenches and transforms are the same samples to the bit, whenever they come.
double rounded(double value) {
  constexpr double kSteps = 1 << 30;
  return std::round(value * kSteps) / kSteps + 0.0;  // no negative zero
}

geometry_msgs::Transform rounded(geometry_msgs::Transform transform) {
  auto& place = transform.translation;
  auto& turn = transform.rotation;
  for (double* value : {&place.x, &place.y, &place.z, &turn.x, &turn.y, &turn.z, &turn.w}) {
    *value = rounded(*value);
  }
  return transform;
}

}  // namespace

std::string frameNameProblem(const std::string& frame) {
  if (frame.empty()) return "its frame_id is empty; name its frame";
  if (frame.front() == '/') {
    return "its frame_id '" + frame + "' begins with '/', which tf2 does not know; leave it out";
  }
  return "";
}

std::string WristPoses::add(const tf2_msgs::TFMessage& message, bool is_static) {
  std::string problem;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    std::string name_problem = frameNameProblem(transform.child_frame_id);
    if (name_problem.empty()) name_problem = frameNameProblem(transform.header.frame_id);
    if (!name_problem.empty()) {
      problem = describe(transform) + ": " + name_problem;
      continue;
    }
    // tf2 would complain about each: a repeated message, a second publisher.
    ros::Time& newest = newest_[transform.child_frame_id];
    if (!is_static && transform.header.stamp <= newest) {
      problem = describe(transform) +
                " is not newer than the one before; do its stamps jitter, or who else sends it?";
      continue;
    }
    newest = transform.header.stamp;
    transforms_.setTransform(transform, is_static ? names::kTfStatic : names::kTf, is_static);
  }
  return problem;
}

bool WristPoses::carriesObject(const std::string& frame) const {
  std::string at = frames_.object;
  std::string parent;
  while (at != frame && transforms_._getParent(at, ros::Time(), parent)) at = parent;
  return at == frame;
}

void WristPoses::clear() {
  transforms_.clear();
  newest_.clear();
}

Result<WrenchSample> WristPoses::sampleOf(const geometry_msgs::WrenchStamped& message) const {
  const ros::Time& stamp = message.header.stamp;
  const Result<Pose> pose = lookUp(frames_.world, frames_.object, stamp);
  if (!pose) return Failure{pose.reason()};
  const Result<Pose> T_object_sensor = lookUp(frames_.object, message.header.frame_id, stamp);
  if (!T_object_sensor) return Failure{T_object_sensor.reason()};
  WrenchSample sample;
  sample.time = stamp.toSec();
  sample.wrench = transformWrench(*T_object_sensor, fromMessage(message.wrench));
  sample.T_world_object = *pose;
  sample.sensor_object = T_object_sensor->translation();
  sample.sensor_axes_object = T_object_sensor->linear();
  return sample;
}

bool WristPoses::begunAfter(const ros::Time& stamp, double lead) const {
  const std::string& world = frames_.world;
  const std::string& object = frames_.object;
  if (transforms_.canTransform(world, object, stamp)) return false;
  if (!transforms_.canTransform(world, object, ros::Time())) return false;
  const ros::Time newest = transforms_.lookupTransform(world, object, ros::Time()).header.stamp;
  const double ahead = newest.toSec() - stamp.toSec();
  return ahead > 0.0 && ahead < lead;
}

Result<Pose> WristPoses::lookUp(const std::string& target, const std::string& source,
                                const ros::Time& stamp) const {
  if (target == source) return Pose(Pose::Identity());
  std::string problem;
  if (!transforms_.canTransform(target, source, stamp, &problem)) {
    return Failure{"tf does not give '" + source + "' in '" + target +
                   "' at its stamp: " + problem};
  }
  return fromTransform(rounded(transforms_.lookupTransform(target, source, stamp).transform));
}

}  // namespace smore
