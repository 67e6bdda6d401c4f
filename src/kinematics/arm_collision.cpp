// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/arm_collision.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "smore/common/result.h"

namespace smore {
namespace {

// Each shape is that much larger than the link [m]: half the distance that is kept.
constexpr double kMargin = 0.0025;

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

Geometry grown(const BoxShape& box) {
  return std::make_shared<fcl::Boxd>(box.size + Vec3::Constant(2.0 * kMargin));
}

Geometry grown(const CylinderShape& cylinder) {
  return std::make_shared<fcl::Cylinderd>(cylinder.radius + kMargin,
                                          cylinder.length + 2.0 * kMargin);
}

Geometry grown(const SphereShape& sphere) {
  return std::make_shared<fcl::Sphered>(sphere.radius + kMargin);
}

Geometry grown(const MeshShape& /*mesh*/) {
  throw InputError("collision meshes of links are not known here; use primitives");
}

struct Part {
  size_t link = 0;
  int joints_before = 0;
  Pose T_link_part = Pose::Identity();
  fcl::CollisionObjectd object;
};

bool touch(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  if (!a.getAABB().overlap(b.getAABB())) return false;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, fcl::CollisionRequestd(), result) > 0;
}

}  // namespace

class ArmCollision::Impl {
 public:
  Impl(const UrdfModel& urdf, const ArmModel* arm) : arm_(arm) {
    const auto& links = arm->tree().links();
    for (size_t i = 0; i < links.size(); ++i) {
      for (const Shape& shape : collisionShapes(urdf, links[i].name)) {
        const Geometry geometry =
            std::visit([](const auto& solid) { return grown(solid); }, shape.geometry);
        parts_.push_back({i, arm->jointCountBefore(static_cast<int>(i)), shape.pose,
                          fcl::CollisionObjectd(geometry)});
      }
    }
  }

  std::vector<Part> partsAt(const JointVector& q) const {
    std::vector<Part> parts = parts_;
    const std::vector<Pose> poses = arm_->linkPoses(q);
    for (Part& part : parts) {
      part.object.setTransform(poses[part.link] * part.T_link_part);
      part.object.computeAABB();
    }
    return parts;
  }

  std::pair<std::string, std::string> names(const Part& a, const Part& b) const {
    return {arm_->tree().links()[a.link].name, arm_->tree().links()[b.link].name};
  }

 private:
  const ArmModel* arm_;
  std::vector<Part> parts_;
};

ArmCollision::ArmCollision(const UrdfModel& urdf, const ArmModel* arm)
    : impl_(std::make_unique<Impl>(urdf, arm)) {}

ArmCollision::~ArmCollision() = default;

std::optional<std::pair<std::string, std::string>> ArmCollision::collidingLinks(
    const JointVector& q) const {
  const std::vector<Part> parts = impl_->partsAt(q);
  for (size_t i = 0; i < parts.size(); ++i) {
    for (size_t k = i + 1; k < parts.size(); ++k) {
      const int joints_between = std::abs(parts[i].joints_before - parts[k].joints_before);
      if (joints_between >= 2 && touch(parts[i].object, parts[k].object)) {
        return impl_->names(parts[i], parts[k]);
      }
    }
  }
  return std::nullopt;
}

double ArmCollision::lowestPoint(const JointVector& q) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Part& part : impl_->partsAt(q)) {
    if (part.joints_before > 0) lowest = std::min(lowest, part.object.getAABB().min_.z());
  }
  return lowest;
}

}  // namespace smore
