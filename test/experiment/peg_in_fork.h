// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/scenario/scenario.h"

namespace smore {

/// A peg between two prongs of the object, with 5 mm of play on each side; goal and workspace are
/// left to who uses it.
inline Scenario pegInFork() {
  Scenario scenario;
  scenario.name = "fork";
  scenario.object = {{BoxShape{Vec3(0.3, 0.06, 0.06)}, makePose(Vec3(0, 0.065, 0))},
                     {BoxShape{Vec3(0.3, 0.06, 0.06)}, makePose(Vec3(0, -0.065, 0))}};
  scenario.environment = {{CylinderShape{0.03, 0.3}, makePose(Vec3(0.05, 0.0, 0.0))}};
  return scenario;
}

}  // namespace smore
