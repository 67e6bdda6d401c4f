// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/scene_check.h"

#include <algorithm>

#include "bullet_shapes.h"
#include "smore/common/result.h"
#include "smore/scenario/solid_distance.h"

namespace smore {
namespace {

constexpr double kClearance = 1e-4;  // [m]

// Notes whether any contact is nearer than the clearance.
class NearestContact : public btCollisionWorld::ContactResultCallback {
 public:
  NearestContact() { m_closestDistanceThreshold = kClearance; }

  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* /*object0*/,
                           int /*part0*/, int /*index0*/,
                           const btCollisionObjectWrapper* /*object1*/, int /*part1*/,
                           int /*index1*/) override {
    found_ = found_ || point.getDistance() < kClearance;
    return 0.0;
  }

  bool found() const { return found_; }

 private:
  bool found_ = false;
};

// A point of a solid, in its parent frame. The origin of a mesh may lie outside of it.
Vec3 pointWithin(const Shape& shape) {
  const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
  return mesh ? Vec3(shape.pose * mesh->vertices.front()) : Vec3(shape.pose.translation());
}

}  // namespace

class SceneCheck::Impl {
 public:
  explicit Impl(const Scenario& scenario)
      : object_shape_(scenario.object, Pose::Identity()),
        solids_(scenario.environment),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_),
        distance_(scenario.environment) {
    for (const Shape& shape : scenario.object) inner_points_.push_back(pointWithin(shape));
    object_.setCollisionShape(object_shape_.shape());
  }

  bool touches(const Pose& T_world_object) {
    object_.setWorldTransform(toBullet(T_world_object));
    NearestContact nearest;
    for (const auto& solid : solids_.solids()) {
      world_.contactPairTest(&object_, solid.get(), nearest);
      if (nearest.found()) return true;
    }
    return isWithinSurface(T_world_object);
  }

 private:
  // A concave mesh is a surface to Bullet; an object wholly within it touches nothing there.
  bool isWithinSurface(const Pose& T_world_object) const {
    return std::any_of(inner_points_.begin(), inner_points_.end(),
                       [&](const Vec3& point) { return distance_(T_world_object * point) < 0.0; });
  }

  BulletCompound object_shape_;
  btCollisionObject object_;
  BulletSolids solids_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  std::vector<Vec3> inner_points_;  ///< one of each of the object's solids, in the object frame
  SolidDistance distance_;          ///< to the environment
};

SceneCheck::SceneCheck(const Scenario& scenario) {
  requireScene(scenario);
  impl_ = std::make_unique<Impl>(scenario);
}

SceneCheck::~SceneCheck() = default;

bool SceneCheck::touches(const Pose& T_world_object) { return impl_->touches(T_world_object); }

void checkStartAndGoalFree(const Scenario& scenario) {
  SceneCheck check(scenario);
  std::string problems;
  const auto complain = [&problems, &scenario](const std::string& key) {
    problems += (problems.empty() ? "" : "\n") + ("scenario " + scenario.name + ": " + key) +
                ": the object touches the environment there; move the " + key +
                " or change the shapes";
  };
  if (check.touches(scenario.start)) complain("start");
  if (check.touches(scenario.goal)) complain("goal");
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace smore
