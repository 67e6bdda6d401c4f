// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "smore/mapping/matter_limits.h"
#include "smore/mapping/surface_patch.h"
#include "smore/mapping/surface_sizes.h"

namespace smore {

/// Flat matter behind a touched surface.
struct SurfaceSheet {
  Eigen::Vector3f touched;  ///< the place in the middle of its front
  Eigen::Vector3f normal;   ///< unit, outward
  float radius;             ///< [m]
  float thickness;          ///< [m]
  PatchCells cells;         ///< as far as free space lets it go on

  /// Whether it lies below or above a place beside the touched one [m].
  bool reaches(const Eigen::Vector3f& offset) const;
};

using TouchedByHypothesis = std::array<std::vector<TouchedPatch>, kHypotheses>;
using SheetsByHypothesis = std::array<std::vector<SurfaceSheet>, kHypotheses>;

/// The world's matter in space as its map has it: around each touch a sheet in place of the balls
/// in which touches are looked up, as a wall mostly goes on farther than the search can afford to
/// assume, and is thinner than what stops a ball. The patches' radii go on to a longer longest one,
/// and each world has one thickness of its own, log-uniform up to the balls' diameter.
class WorldSheets {
 public:
  /// No matter.
  WorldSheets() = default;

  /// `touched`: the patches in each world around balls of matter. `limits`: of the world. Lengths
  /// in metres; `seed` turns the lattices of cells.
  WorldSheets(TouchedByHypothesis touched, MatterLimits limits, const FeatureParameters& feature,
              const ExtentParameters& extent, std::uint64_t seed);

  /// Of all touches of each world. Made at each call, on all processor cores: plans do without.
  SheetsByHypothesis all() const;

 private:
  struct Known {
    TouchedByHypothesis touched;
    MatterLimits limits;
    FeatureParameters feature;
    ExtentParameters extent;
    std::uint64_t seed;
  };
  static std::vector<SurfaceSheet> sheetsOf(const Known& known, int hypothesis);

  std::shared_ptr<const Known> known_;
};

}  // namespace smore
