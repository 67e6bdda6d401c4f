// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <string>
#include <vector>

#include "bullet_shapes.h"
#include "cone_friction_solver.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/mass_properties.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// One rigid body of convex solids, in its own frame.
struct CarriedBody {
  std::vector<Shape> shapes;
  std::vector<std::string> names;  ///< what each of the shapes is a part of
  MassProperties mass;
};

/// The scenario's object as a body of its own.
CarriedBody objectBody(const Scenario& scenario);

/// Motion of the object's centre of mass: what the dynamics act on.
struct ObjectMotion {
  Pose T_world_object = Pose::Identity();
  Vec3 center = Vec3::Zero();            ///< of mass, in the world [m]
  Vec3 linear_velocity = Vec3::Zero();   ///< of the centre of mass, in the world [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< in the world [rad/s]
};

/// A body among the fixed environment in Bullet, moved by gravity, by the wrench that the hand
/// exerts and by contact with friction.
class BulletWorld {
 public:
  /// The environment and the friction are the scenario's. `gravity` [m/s^2], `step` [s], positive.
  BulletWorld(const Scenario& scenario, const CarriedBody& body, const Vec3& gravity, double step);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  /// Sets the object to a pose at rest and forgets its contacts.
  void place(const Pose& T_world_object);

  /// Changes the object's velocity, in the world: as a force that no sensor sees would.
  void changeVelocity(const Vec3& linear, const Vec3& angular);

  /// Advances one step under a wrench on the object at its frame's origin, in the world's axes.
  void step(const Wrench& wrench_world);

  ObjectMotion motion() const;

  /// Points with a force in the last step.
  std::vector<ContactPoint> contacts() const;

  /// Whether there is any such point.
  bool inContact() const;

 private:
  void addObject(const MassProperties& object, double friction);

  double step_;
  Pose T_object_body_;              ///< centre of mass and principal axes
  std::vector<std::string> names_;  ///< of the body's shapes
  BulletCompound object_shape_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  ConeFrictionSolver solver_;
  BulletSolids environment_;
  std::unique_ptr<btRigidBody> object_;
  btDiscreteDynamicsWorld world_;
};

}  // namespace smore
