// SPDX-License-Identifier: BSD-3-Clause
#include "bullet_world.h"

namespace smore {
namespace {

// One body's contacts converge within a few sweeps; the bound is for jams.
constexpr int kSolverIterations = 100;

// The solver stops when no row changes its relative velocity by more than this [m/s]: with half a
// kilogram and a step of a millisecond a force of 0.5 mN.
constexpr double kSolverVelocityTolerance = 1e-6;

// Share of a penetration that each step takes back. It moves the object without adding velocity, so
// that no contact force comes of it.
constexpr double kPenetrationRecovery = 0.05;

void configure(btContactSolverInfo* solver) {
  solver->m_numIterations = kSolverIterations;
  solver->m_leastSquaresResidualThreshold = kSolverVelocityTolerance * kSolverVelocityTolerance;
  solver->m_erp2 = kPenetrationRecovery;
  solver->m_splitImpulsePenetrationThreshold = 0.0;
  // Without the second direction friction acts along one line of the contact plane only; directions
  // that follow the sliding velocity turn about at rest, and with them the friction.
  solver->m_solverMode |=
      SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION;
}

// Force on the first body of the manifold.
Vec3 forceOf(const btManifoldPoint& point, double step) {
  const btVector3 impulse = point.m_normalWorldOnB * point.m_appliedImpulse +
                            point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1 +
                            point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
  return fromBullet(impulse) / step;
}

}  // namespace

CarriedBody objectBody(const Scenario& scenario) {
  return {scenario.object, std::vector<std::string>(scenario.object.size(), kObjectBody),
          massProperties(scenario.object, scenario.object_mass)};
}

BulletWorld::BulletWorld(const Scenario& scenario, const CarriedBody& body, const Vec3& gravity,
                         double step)
    : step_(step),
      T_object_body_(principalFrame(body.mass)),
      names_(body.names),
      object_shape_(body.shapes, T_object_body_.inverse()),
      dispatcher_(&configuration_),
      environment_(scenario.environment),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  world_.setGravity(toBullet(gravity));
  world_.setForceUpdateAllAabbs(false);
  configure(&world_.getSolverInfo());
  for (const auto& solid : environment_.solids()) {
    solid->setFriction(1.0);  // Bullet takes the product of both
    world_.addCollisionObject(solid.get(), btBroadphaseProxy::StaticFilter,
                              btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
  }
  addObject(body.mass, scenario.friction);
  place(scenario.start);
}

BulletWorld::~BulletWorld() {
  world_.removeRigidBody(object_.get());
  for (const auto& solid : environment_.solids()) world_.removeCollisionObject(solid.get());
}

void BulletWorld::addObject(const MassProperties& object, double friction) {
  const Eigen::Matrix3d axes = T_object_body_.linear();
  const Vec3 inertia = (axes.transpose() * object.inertia * axes).diagonal();
  btRigidBody::btRigidBodyConstructionInfo info(object.mass, nullptr, object_shape_.shape(),
                                                toBullet(inertia));
  info.m_friction = friction;
  object_ = std::make_unique<btRigidBody>(info);
  object_->setActivationState(DISABLE_DEACTIVATION);
  object_->setFlags(0);  // no gyroscopic torque: a turn at constant rate needs no wrench
  world_.addRigidBody(object_.get());
}

void BulletWorld::place(const Pose& T_world_object) {
  const btTransform transform = toBullet(Pose(T_world_object * T_object_body_));
  object_->setWorldTransform(transform);
  object_->setInterpolationWorldTransform(transform);
  object_->setLinearVelocity(btVector3(0, 0, 0));
  object_->setAngularVelocity(btVector3(0, 0, 0));
  object_->clearForces();
  broadphase_.getOverlappingPairCache()->cleanProxyFromPairs(object_->getBroadphaseHandle(),
                                                             &dispatcher_);
}

void BulletWorld::changeVelocity(const Vec3& linear, const Vec3& angular) {
  object_->setLinearVelocity(object_->getLinearVelocity() + toBullet(linear));
  object_->setAngularVelocity(object_->getAngularVelocity() + toBullet(angular));
}

void BulletWorld::step(const Wrench& wrench_world) {
  const Vec3 lever =
      fromBullet(object_->getWorldTransform()).linear() * T_object_body_.inverse().translation();
  object_->applyCentralForce(toBullet(wrench_world.force));
  object_->applyTorque(toBullet(Vec3(wrench_world.torque + lever.cross(wrench_world.force))));
  world_.stepSimulation(step_, 0);
}

ObjectMotion BulletWorld::motion() const {
  ObjectMotion motion;
  motion.T_world_object = fromBullet(object_->getWorldTransform()) * T_object_body_.inverse();
  motion.center = fromBullet(object_->getWorldTransform().getOrigin());
  motion.linear_velocity = fromBullet(object_->getLinearVelocity());
  motion.angular_velocity = fromBullet(object_->getAngularVelocity());
  return motion;
}

std::vector<ContactPoint> BulletWorld::contacts() const {
  std::vector<ContactPoint> contacts;
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold =
        const_cast<btCollisionDispatcher&>(dispatcher_).getManifoldByIndexInternal(i);
    const bool is_first = manifold->getBody0() == object_.get();
    const double sign = is_first ? 1.0 : -1.0;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      if (point.m_appliedImpulse <= 0.0) continue;
      const Vec3 position =
          fromBullet((point.getPositionWorldOnA() + point.getPositionWorldOnB()) * btScalar(0.5));
      const int child = is_first ? point.m_index0 : point.m_index1;
      contacts.push_back(
          {position, sign * forceOf(point, step_), names_[object_shape_.shapeOf(child)]});
    }
  }
  return contacts;
}

bool BulletWorld::inContact() const {
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold =
        const_cast<btCollisionDispatcher&>(dispatcher_).getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      if (manifold->getContactPoint(k).m_appliedImpulse > 0.0) return true;
    }
  }
  return false;
}

}  // namespace smore
