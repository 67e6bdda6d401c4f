// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "smore/scenario/scenario.h"

namespace smore {

/// Tells whether the object touches the environment of a scenario, by Bullet's geometry.
class SceneCheck {
 public:
  /// InputError for a task without a scene.
  explicit SceneCheck(const Scenario& scenario);
  ~SceneCheck();

  /// True where the object at this pose overlaps the environment or is nearer than 0.1 mm to it.
  bool touches(const Pose& T_world_object);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// InputError for a task without a scene, and where start or goal touch the environment: which of
/// them, and what to change.
void checkStartAndGoalFree(const Scenario& scenario);

}  // namespace smore
