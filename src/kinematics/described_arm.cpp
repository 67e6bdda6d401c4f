// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/described_arm.h"

#include <sstream>

#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

// A factory calibration moves a joint by millimetres; the arms of the family differ by decimetres.
constexpr double kFarthest = 0.05;   // [m]
constexpr double kMostTurned = 0.1;  // [rad]

// What printed numbers are rounded to, and less than any calibration changes.
constexpr double kRounding = 1e-5;  // [m], [rad]

/// `joint`: of the description, with the place where that comes from.
[[noreturn]] void refuse(const Scenario& scenario, const std::string& joint,
                         const std::string& what) {
  throw InputError(joint + ": " + what + "; it must be that of a " + robotText(scenario) +
                   " (robot: of the scenario); without robot_description the nominal "
                   "arm is taken");
}

void checkPlace(const Scenario& scenario, const std::string& joint, const urdf::Joint& own,
                const urdf::Joint& described) {
  if (described.parent_link_name != own.parent_link_name ||
      described.child_link_name != own.child_link_name) {
    refuse(scenario, joint,
           "it joins " + described.parent_link_name + " and " + described.child_link_name +
               ", not " + own.parent_link_name + " and " + own.child_link_name);
  }
  const Pose nominal = toPose(own.parent_to_joint_origin_transform);
  const Pose found = toPose(described.parent_to_joint_origin_transform);
  if (distanceBetween(nominal, found) > kFarthest || angleBetween(nominal, found) > kMostTurned) {
    std::ostringstream what;
    what << "it stands " << distanceBetween(nominal, found) << " m and "
         << angleBetween(nominal, found) << " rad from where the nominal arm has it";
    refuse(scenario, joint, what.str());
  }
}

}  // namespace

UrdfModel describedArm(const Scenario& scenario, const UrdfModel& description) {
  UrdfModel urdf = armUrdf(scenario);
  const ArmModel model(urdf);
  for (const std::string& name : model.jointNames()) {
    const urdf::JointSharedPtr own = urdf->joints_.at(name);
    const urdf::JointConstSharedPtr described = description->getJoint(name);
    const std::string joint = description.source + ": joint " + name;
    if (!described) refuse(scenario, joint, "it is not there");
    if (!described->limits) refuse(scenario, joint, "it has no limits");
    checkPlace(scenario, joint, *own, *described);
    own->parent_to_joint_origin_transform = described->parent_to_joint_origin_transform;
    *own->limits = *described->limits;
  }
  urdf.source += " with the joints of " + description.source;
  return urdf;
}

bool isCalibrated(const Scenario& scenario, const UrdfModel& arm) {
  const UrdfModel nominal = armUrdf(scenario);
  const ArmModel model(nominal);
  for (const std::string& name : model.jointNames()) {
    const Pose table = toPose(nominal->getJoint(name)->parent_to_joint_origin_transform);
    const Pose found = toPose(arm->getJoint(name)->parent_to_joint_origin_transform);
    if (distanceBetween(table, found) > kRounding || angleBetween(table, found) > kRounding) {
      return true;
    }
  }
  return false;
}

}  // namespace smore
