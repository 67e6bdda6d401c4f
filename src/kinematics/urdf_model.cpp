// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/urdf_model.h"

#include <urdf_parser/urdf_parser.h>

#include <fstream>
#include <sstream>

#include "smore/common/result.h"

namespace smore {
namespace {

/// `place`: file and link, for messages.
Shape shapeOf(const urdf::Collision& collision, const std::string& place) {
  Shape shape;
  shape.pose = toPose(collision.origin);
  const urdf::Geometry& geometry = *collision.geometry;
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const urdf::Vector3& size = dynamic_cast<const urdf::Box&>(geometry).dim;
      shape.geometry = BoxShape{Vec3(size.x, size.y, size.z)};
      return shape;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
      shape.geometry = CylinderShape{cylinder.radius, cylinder.length};
      return shape;
    }
    case urdf::Geometry::SPHERE:
      shape.geometry = SphereShape{dynamic_cast<const urdf::Sphere&>(geometry).radius};
      return shape;
    case urdf::Geometry::MESH:
      break;
  }
  throw InputError(place +
                   ": the collision geometry is a mesh; describe it by boxes, cylinders and "
                   "spheres");
}

}  // namespace

UrdfModel parseUrdf(const std::string& xml, const std::string& source) {
  UrdfModel urdf{urdf::parseURDF(xml), source};
  if (!urdf.model) {
    throw InputError(source + ": is no valid URDF; its parser's message stands above");
  }
  return urdf;
}

UrdfModel loadUrdf(const std::string& file) {
  const std::ifstream stream(file);
  if (!stream) throw InputError(file + ": cannot be read; check the path of the URDF");
  std::ostringstream text;
  text << stream.rdbuf();
  return parseUrdf(text.str(), file);
}

UrdfModel armUrdf(const Scenario& scenario) {
  if (scenario.robot == RobotKind::kUrdf) return loadUrdf(scenario.robot_urdf);
  return armUrdf(scenario.robot);
}

Pose toPose(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  Pose result = Pose::Identity();
  result.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  result.translation() = Vec3(pose.position.x, pose.position.y, pose.position.z);
  return result;
}

std::vector<Shape> collisionShapes(const UrdfModel& urdf, const std::string& link) {
  std::vector<Shape> shapes;
  for (const auto& collision : urdf->getLink(link)->collision_array) {
    shapes.push_back(shapeOf(*collision, urdf.source + ": link " + link));
  }
  return shapes;
}

}  // namespace smore
