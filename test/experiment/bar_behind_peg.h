// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/scenario/scenario.h"

namespace smore {

/// A bar behind one peg: two or three touches find the way.
inline Scenario barBehindPeg() {
  Scenario scenario;
  scenario.name = "small";
  scenario.object = {{BoxShape{Vec3(0.06, 0.3, 0.06)}, Pose::Identity()}};
  scenario.environment = {{CylinderShape{0.03, 0.3}, makePose(Vec3(-0.2, 0.1, 0.0))}};
  scenario.goal = makePose(Vec3(-0.4, 0, 0));
  scenario.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.2, 0.4, 0.01)};
  scenario.perturb = {0.01, 0.05};
  return scenario;
}

}  // namespace smore
