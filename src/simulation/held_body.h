// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bullet_world.h"
#include "smore/simulation/wrist_spring.h"

namespace smore {

/// What a wrist sensor carries, in its scene: one rigid body that hangs on the hand by the wrist's
/// spring, whose wrench is what the sensor reads.
class HeldBody {
 public:
  /// How the body moves in free space.
  enum class Feel {
    kEverything,    ///< its weight and its inertia are in the reading
    kContactsOnly,  ///< no weight, and no inertia while it touches nothing: as if a force that no
                    ///< sensor sees took it along
  };

  /// The body's frame is the hand's. `step` [s], positive.
  HeldBody(const Scenario& scenario, const CarriedBody& body, const Pose& T_world_hand, Feel feel,
           double step);

  /// Sets the body to where it hangs at rest in the hand, touching nothing.
  void place(const Pose& T_world_hand);

  /// Advances one step, during which the hand moves between two poses. The wrench of the spring
  /// acts during the whole step, from where hand and body are at its beginning.
  void advance(const Pose& T_world_hand_before, const Pose& T_world_hand_after);

  /// The wrench on the body but for the spring's, in the last step, at the origin and in the axes
  /// of the hand's frame.
  Wrench environmentWrench(const Pose& T_world_hand) const;

  std::vector<ContactPoint> contacts() const { return world_.contacts(); }

 private:
  /// Of a body that moves with the hand, at its centre of mass.
  struct HandVelocity {
    Vec3 linear = Vec3::Zero();   ///< [m/s]
    Vec3 angular = Vec3::Zero();  ///< [rad/s]
  };

  HandVelocity velocityBetween(const Pose& before, const Pose& after) const;
  Wrench springWrench(const Pose& T_world_hand, const HandVelocity& hand_velocity) const;
  Pose hangingPose(const Pose& T_world_hand) const;

  MassProperties mass_;
  Feel feel_;
  double step_;
  BulletWorld world_;
  WristSpring spring_;
  HandVelocity hand_velocity_;
  Wrench environment_wrench_;  ///< at the origin of the body's frame, in the axes of the world
  Vec3 wrench_origin_;         ///< where that origin was
};

}  // namespace smore
