// SPDX-License-Identifier: BSD-3-Clause
#include "carried_load.h"

#include <algorithm>

#include "smore/common/result.h"
#include "smore/simulation/scene_check.h"
#include "urdf_multibody.h"

namespace smore {
namespace {

constexpr double kAngleTolerance = 5e-4;  // [rad]: 0.03 mm at the pads

std::vector<double> fingerVariables(const KinematicTree& gripper, double angle) {
  return std::vector<double>(gripper.jointNames().size(), angle);
}

// Shapes of a link, in the tool's frame.
std::vector<Shape> shapesAt(const UrdfModel& urdf, const TreeLink& link, const Pose& T_tool_link) {
  std::vector<Shape> shapes = collisionShapes(urdf, link.name);
  for (Shape& shape : shapes) shape.pose = T_tool_link * shape.pose;
  return shapes;
}

// Whether the moving parts of the gripper touch the object.
bool fingersTouch(const Scenario& scenario, const UrdfModel& urdf, const KinematicTree& gripper,
                  const Pose& T_tool_object, double angle) {
  Scenario grasp = scenario;
  grasp.object.clear();
  const std::vector<Pose> poses = gripper.linkPoses(fingerVariables(gripper, angle));
  for (size_t i = 0; i < poses.size(); ++i) {
    if (gripper.links()[i].variable < 0) continue;
    for (const Shape& shape : shapesAt(urdf, gripper.links()[i], poses[i])) {
      grasp.object.push_back(shape);
    }
  }
  grasp.environment = scenario.object;
  for (Shape& shape : grasp.environment) shape.pose = T_tool_object * shape.pose;
  return SceneCheck(grasp).touches(Pose::Identity());
}

}  // namespace

urdf::JointConstSharedPtr describedFinger(const UrdfModel& urdf, const KinematicTree& gripper) {
  if (gripper.jointNames().empty()) return nullptr;
  if (gripper.jointNames().size() > 1) {
    throw InputError(urdf.source + ": the gripper must have one joint that all its others mimic");
  }
  const std::string& name = gripper.jointNames().front();
  urdf::JointConstSharedPtr joint = urdf->getJoint(name);
  if (joint == nullptr || joint->limits == nullptr) {
    throw InputError(urdf.source + ": the gripper's joint " + name +
                     (joint == nullptr ? " is mimicked, but not there; add it"
                                       : " has no limits; give it upper and velocity"));
  }
  if (!(joint->limits->velocity > 0.0) || !(joint->limits->upper > 0.0)) {
    throw InputError(urdf.source + ": the gripper's joint " + name + ": an upper limit of " +
                     std::to_string(joint->limits->upper) + " and a velocity of " +
                     std::to_string(joint->limits->velocity) +
                     "; both must be above 0, where it is open");
  }
  return joint;
}

Result<double> graspAngle(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
                          const Pose& T_tool_object) {
  const KinematicTree gripper(urdf, frames.tool);
  const auto finger = describedFinger(urdf, gripper);
  if (finger == nullptr) return 0.0;
  const double closed = finger->limits->upper;
  if (fingersTouch(scenario, urdf, gripper, T_tool_object, 0.0)) {
    return Failure{
        "the open gripper touches the object: it is too wide for the gripper, or the finger's "
        "joint is not open at 0"};
  }
  double open = 0.0;
  double touching = closed;
  if (!fingersTouch(scenario, urdf, gripper, T_tool_object, touching)) {
    return Failure{"the gripper closes without touching the object"};
  }
  // Fingers that touch go on touching while they close.
  while (touching - open > kAngleTolerance) {
    const double middle = 0.5 * (open + touching);
    const bool touch = fingersTouch(scenario, urdf, gripper, T_tool_object, middle);
    (touch ? touching : open) = middle;
  }
  return open;
}

CarriedBody gripperBody(const UrdfModel& urdf, const ArmFrames& frames, double finger_angle) {
  const KinematicTree gripper(urdf, frames.tool);
  const std::vector<Pose> poses = gripper.linkPoses(fingerVariables(gripper, finger_angle));
  CarriedBody body;
  std::vector<MassProperties> masses;
  for (size_t i = 0; i < poses.size(); ++i) {
    const TreeLink& link = gripper.links()[i];
    masses.push_back(transformMass(poses[i], massOf(*urdf->getLink(link.name))));
    for (Shape& shape : shapesAt(urdf, link, poses[i])) {
      body.shapes.push_back(std::move(shape));
      body.names.push_back(link.name);
    }
  }
  body.mass = joined(masses);
  return body;
}

CarriedBody withObject(CarriedBody gripper, const CarriedBody& object, const Pose& T_tool_object) {
  for (size_t i = 0; i < object.shapes.size(); ++i) {
    gripper.shapes.push_back(object.shapes[i]);
    gripper.shapes.back().pose = T_tool_object * object.shapes[i].pose;
    gripper.names.push_back(object.names[i]);
  }
  gripper.mass = joined({gripper.mass, transformMass(T_tool_object, object.mass)});
  return gripper;
}

}  // namespace smore
