// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "bullet_shapes.h"
#include "bullet_world.h"
#include "smore/kinematics/arm_motion.h"
#include "smore/scenario/scenario.h"
#include "urdf_multibody.h"

namespace smore {

/// Two bodies that touch where none should: a link of the arm and a solid of the environment,
/// another link, or what the hand carries.
struct LinkContact {
  std::string link;
  std::string other;

  bool operator<(const LinkContact& b) const {
    return std::tie(link, other) < std::tie(b.link, b.other);
  }
};

/// The arm up to its wrist sensor among the environment: a multi-body with motors under gravity.
/// What the sensor carries is no part of it, but its contacts with the arm's links are seen here.
class ArmWorld {
 public:
  /// `step` [s], positive.
  ArmWorld(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
           const CarriedBody& carried, double step);
  ~ArmWorld();
  ArmWorld(const ArmWorld&) = delete;
  ArmWorld& operator=(const ArmWorld&) = delete;

  UrdfMultibody& arm() { return arm_; }
  const UrdfMultibody& arm() const { return arm_; }

  /// Replaces what the hand carries.
  void setCarried(const CarriedBody& carried);

  /// Sets the joints, at rest, and forgets contacts.
  void place(const std::vector<double>& positions);

  /// Advances one step under a wrench on the tool at its origin, in the world's axes.
  void step(const Wrench& tool_wrench_world);

  /// The contacts of the arm's links in the last step.
  std::set<LinkContact> linkContacts() const;

 private:
  std::string nameOf(const btCollisionObject* body, int shape) const;
  bool isLink(const btCollisionObject* body) const;
  /// Whether a body of the arm and what the hand carries of that name may overlap.
  bool mayOverlap(const btCollisionObject* body, const std::string& other) const;

  double step_;
  std::vector<std::string> carried_names_;
  std::unique_ptr<BulletCompound> carried_shape_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  BulletSolids environment_;
  btCollisionObject carried_;
  UrdfMultibody arm_;
  btMultiBodyDynamicsWorld world_;
};

}  // namespace smore
