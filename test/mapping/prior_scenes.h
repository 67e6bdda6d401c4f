// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "../common/refusal.h"
#include "smore/mapping/octomap_export.h"
#include "smore/mapping/prior_maps.h"

namespace smore {

// A bar in front of a peg, in the plane z = 0; lattices of 1 cm.
inline Scenario sceneWith(const PriorSources& prior) {
  Scenario scene;
  scene.name = "small";
  scene.voxel_size = 0.04;
  scene.object = {{BoxShape{Vec3(0.1, 0.3, 0.06)}, Pose::Identity()}};
  scene.environment = {{CylinderShape{0.05, 0.3}, makePose(Vec3(-0.3, 0.1, 0.0))}};
  scene.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.2, 0.4, 0.01)};
  scene.prior = prior;
  return scene;
}

inline PriorSource truth() { return {}; }

inline PriorSource fromFile(PriorFormat format, const std::string& file) {
  PriorSource source;
  source.format = format;
  source.file = file;
  return source;
}

enum class Said { kNothing, kFree, kMatter };

inline Said saidAt(const Prior& prior, const Vec3& place) {
  const auto probability = prior.known.probability(voxelAt(place, prior.known.voxelSize()));
  if (!probability) return Said::kNothing;
  return *probability >= kOccupied ? Said::kMatter : Said::kFree;
}

inline std::string problemOf(const Scenario& scene) {
  return refusalOf([&] { return makePriors(scene); });
}

}  // namespace smore
