// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/scene_check.h"

#include "bullet_shapes.h"
#include "smore/common/result.h"

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

}  // namespace

class SceneCheck::Impl {
 public:
  explicit Impl(const Scenario& scenario)
      : object_shape_(scenario.object, Pose::Identity()),
        solids_(scenario.environment),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_),
        shapes_(scenario.object),
        environment_(scenario.environment) {
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
    for (const Shape& shape : shapes_) {
      const Vec3 center = (T_world_object * shape.pose).translation();
      if (signedDistance(environment_, center) < 0.0) return true;
    }
    return false;
  }

  BulletCompound object_shape_;
  btCollisionObject object_;
  BulletSolids solids_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  std::vector<Shape> shapes_;
  std::vector<Shape> environment_;
};

SceneCheck::SceneCheck(const Scenario& scenario) : impl_(std::make_unique<Impl>(scenario)) {}

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
