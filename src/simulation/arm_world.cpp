// SPDX-License-Identifier: BSD-3-Clause
#include "arm_world.h"

#include <algorithm>

#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

constexpr int kSolverIterations = 50;

// The solver stops when no row changes its relative velocity by more than this [rad/s].
constexpr double kSolverVelocityTolerance = 1e-7;

// Collision groups. The environment and what the hand carries meet in the world of the held body.
constexpr int kEnvironmentGroup = btBroadphaseProxy::StaticFilter;
constexpr int kCarriedGroup = btBroadphaseProxy::KinematicFilter;
constexpr int kLinkGroup = btBroadphaseProxy::DefaultFilter;

}  // namespace

ArmWorld::ArmWorld(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
                   const CarriedBody& carried, double step)
    : step_(step),
      dispatcher_(&configuration_),
      environment_(scenario.environment),
      arm_(urdf, frames.base, frames.tool, scenario.T_world_base, step),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  world_.setGravity(toBullet(gravity()));
  world_.getSolverInfo().m_numIterations = kSolverIterations;
  world_.getSolverInfo().m_leastSquaresResidualThreshold =
      kSolverVelocityTolerance * kSolverVelocityTolerance;
  for (const auto& solid : environment_.solids()) {
    // The arm's base stands on something.
    solid->setIgnoreCollisionCheck(arm_.baseCollider(), true);
    world_.addCollisionObject(solid.get(), kEnvironmentGroup, kLinkGroup);
  }
  arm_.addTo(&world_, kLinkGroup, btBroadphaseProxy::AllFilter);
  carried_.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT |
                             btCollisionObject::CF_NO_CONTACT_RESPONSE);
  carried_.setIgnoreCollisionCheck(arm_.lastCollider(), true);
  carried_.setActivationState(DISABLE_DEACTIVATION);
  setCarried(carried);
}

ArmWorld::~ArmWorld() {
  world_.removeCollisionObject(&carried_);
  arm_.removeFrom(&world_);
  for (const auto& solid : environment_.solids()) world_.removeCollisionObject(solid.get());
}

void ArmWorld::setCarried(const CarriedBody& carried) {
  if (carried_shape_) world_.removeCollisionObject(&carried_);
  carried_names_ = carried.names;
  carried_shape_ = std::make_unique<BulletCompound>(carried.shapes, Pose::Identity());
  carried_.setCollisionShape(carried_shape_->shape());
  world_.addCollisionObject(&carried_, kCarriedGroup, kLinkGroup);
}

void ArmWorld::place(const std::vector<double>& positions) {
  arm_.place(positions);
  carried_.setWorldTransform(toBullet(arm_.lastPose()));
  world_.updateAabbs();
}

void ArmWorld::step(const Wrench& tool_wrench_world) {
  arm_.applyWrench(tool_wrench_world);
  carried_.setWorldTransform(toBullet(arm_.lastPose()));
  world_.stepSimulation(step_, 0);
}

std::set<LinkContact> ArmWorld::linkContacts() const {
  std::set<LinkContact> contacts;
  auto& dispatcher = const_cast<btCollisionDispatcher&>(dispatcher_);
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      if (point.getDistance() > 0.0 && point.m_appliedImpulse <= 0.0) continue;
      const std::string first = nameOf(manifold->getBody0(), point.m_index0);
      const std::string second = nameOf(manifold->getBody1(), point.m_index1);
      if (mayOverlap(manifold->getBody0(), second) || mayOverlap(manifold->getBody1(), first)) {
        continue;
      }
      const bool first_is_link = isLink(manifold->getBody0());
      contacts.insert(first_is_link ? LinkContact{first, second} : LinkContact{second, first});
    }
  }
  return contacts;
}

// As links do that one joint joins, the gripper and the link before the last may overlap. What the
// gripper holds may not.
bool ArmWorld::mayOverlap(const btCollisionObject* body, const std::string& other) const {
  const auto end = carried_names_.end();
  return body == arm_.colliderBeforeLast() && other != kObjectBody &&
         std::find(carried_names_.begin(), end, other) != end;
}

bool ArmWorld::isLink(const btCollisionObject* body) const {
  return btMultiBodyLinkCollider::upcast(body) != nullptr;
}

std::string ArmWorld::nameOf(const btCollisionObject* body, int shape) const {
  if (isLink(body)) return arm_.linkName(body, shape);
  if (body == &carried_) return carried_names_[carried_shape_->shapeOf(shape)];
  return "the environment";
}

}  // namespace smore
