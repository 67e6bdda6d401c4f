// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/parameters.h"

namespace smore {

/// What a piece of prior knowledge is read from.
enum class PriorFormat {
  kTruth,   ///< the solids of the simulated trial themselves
  kMesh,    ///< a solid: STL, OBJ, PLY with faces, DAE
  kCloud,   ///< points on surfaces: PCD, PLY without faces
  kOctree,  ///< an OctoMap: .ot, .bt
};

/// Values that an entry may have: what is farther from the frame of its map [m], or is nearly
/// certain, is a slip.
constexpr Range kPriorPosition{-100.0, 100.0};
constexpr Range kPriorConfidence{0.001, 1.0 - 1e-9};

/// The files that an entry may be read from, for messages.
constexpr char kPriorFiles[] =
    "a mesh (.stl, .obj, .ply, .dae), a cloud of points (.pcd, .ply), an OctoMap (.ot, .bt)";

/// An entry of a scenario's key `prior` (docs/priors.md).
struct PriorSource {
  PriorFormat format = PriorFormat::kTruth;
  std::string file;              ///< of all but kTruth and `points`
  std::vector<Vec3> points;      ///< of kCloud without a file, finite and at least one [m]
  Vec3 scale = Vec3::Ones();     ///< of a mesh or a cloud
  Pose pose = Pose::Identity();  ///< of what the file holds, in the frame of its map
  std::optional<Bounds> box;     ///< what counts of it, in that frame [m]; nothing: all
  Vec3 offset = Vec3::Zero();    ///< by which it is then moved [m]
  double confidence = 0.999;     ///< probability that it is true, above 0 and below 1
};

/// Format of a file by its name's end, and of PLY files by whether they have faces; nothing for any
/// other end.
std::optional<PriorFormat> priorFormatOf(const std::string& file);

/// What a scenario says to be known of each map.
struct PriorSources {
  std::vector<PriorSource> object;
  std::vector<PriorSource> world;

  bool empty() const { return object.empty() && world.empty(); }
};

}  // namespace smore
