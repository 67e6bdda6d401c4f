// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/calibrated_arm.h"

#include <iomanip>
#include <random>
#include <sstream>

#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

// A turn by small angles about three axes.
urdf::Rotation turned(const urdf::Rotation& rotation, const Vec3& angles) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angles.norm(), angles.stableNormalized()));
  const Eigen::Quaterniond result =
      Eigen::Quaterniond(rotation.w, rotation.x, rotation.y, rotation.z) * turn;
  return {result.x(), result.y(), result.z(), result.w()};
}

void writeOrigin(const urdf::Pose& origin, std::ostream* text) {
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  origin.rotation.getRPY(roll, pitch, yaw);
  *text << R"(<origin xyz=")" << origin.position.x << ' ' << origin.position.y << ' '
        << origin.position.z << R"(" rpy=")" << roll << ' ' << pitch << ' ' << yaw << R"("/>)";
}

void writeJoint(const urdf::Joint& joint, std::ostream* text) {
  const bool moves = joint.type != urdf::Joint::FIXED;
  *text << R"(<joint name=")" << joint.name << R"(" type=")" << (moves ? "revolute" : "fixed")
        << R"("><parent link=")" << joint.parent_link_name << R"("/><child link=")"
        << joint.child_link_name << R"("/>)";
  writeOrigin(joint.parent_to_joint_origin_transform, text);
  if (!moves) {
    *text << "</joint>\n";
    return;
  }
  *text << R"(<axis xyz=")" << joint.axis.x << ' ' << joint.axis.y << ' ' << joint.axis.z
        << R"("/><limit lower=")" << joint.limits->lower << R"(" upper=")" << joint.limits->upper
        << R"(" velocity=")" << joint.limits->velocity << R"(" effort=")" << joint.limits->effort
        << "\"/></joint>\n";
}

// Empty for what lies in files of its own.
std::string geometryOf(const urdf::Visual& visual) {
  std::ostringstream text;
  if (visual.geometry->type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(*visual.geometry);
    text << R"(<cylinder radius=")" << cylinder.radius << R"(" length=")" << cylinder.length;
  } else if (visual.geometry->type == urdf::Geometry::BOX) {
    const urdf::Vector3& size = static_cast<const urdf::Box&>(*visual.geometry).dim;
    text << R"(<box size=")" << size.x << ' ' << size.y << ' ' << size.z;
  } else if (visual.geometry->type == urdf::Geometry::SPHERE) {
    text << R"(<sphere radius=")" << static_cast<const urdf::Sphere&>(*visual.geometry).radius;
  } else {
    return "";
  }
  return "<geometry>" + text.str() + "\"/></geometry>";
}

void writeVisual(const urdf::Visual& visual, std::ostream* text) {
  const std::string geometry = geometryOf(visual);
  if (geometry.empty()) return;
  *text << "<visual>" << geometry;
  writeOrigin(visual.origin, text);
  if (visual.material) {
    const urdf::Color& color = visual.material->color;
    *text << R"(<material name=")" << visual.material_name << R"("><color rgba=")" << color.r << ' '
          << color.g << ' ' << color.b << ' ' << color.a << R"("/></material>)";
  }
  *text << "</visual>";
}

void writeLink(const urdf::Link& link, std::ostream* text) {
  *text << R"(<link name=")" << link.name << R"(">)";
  for (const auto& visual : link.visual_array) writeVisual(*visual, text);
  *text << "</link>\n";
}

}  // namespace

UrdfModel calibratedArm(const Scenario& scenario, double stddev, std::uint64_t seed) {
  UrdfModel urdf = armUrdf(scenario);
  if (stddev <= 0.0) return urdf;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> error(0.0, stddev);
  const auto draw = [&] { return Vec3(error(random), error(random), error(random)); };
  const ArmModel model(urdf);
  for (const std::string& name : model.jointNames()) {
    urdf::Pose& origin = urdf->joints_.at(name)->parent_to_joint_origin_transform;
    const Vec3 moved = draw();
    origin.position.x += moved.x();
    origin.position.y += moved.y();
    origin.position.z += moved.z();
    origin.rotation = turned(origin.rotation, draw());
  }
  return urdf;
}

std::string jointsDescription(const UrdfModel& arm) {
  std::ostringstream text;
  text << std::setprecision(17) << R"(<?xml version="1.0"?><robot name="calibrated_arm">)"
       << "\n";
  const ArmModel model(arm);
  const std::string root = arm->getJoint(model.jointNames().front())->parent_link_name;
  urdf::LinkConstSharedPtr link =
      arm->getLink(arm->getJoint(model.jointNames().back())->child_link_name);
  for (; link->name != root; link = link->getParent()) {
    writeJoint(*link->parent_joint, &text);  // with the fixed ones between two that move
    writeLink(*link, &text);
  }
  writeLink(*link, &text);
  text << "</robot>\n";
  return text.str();
}

}  // namespace smore
