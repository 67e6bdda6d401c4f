// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/world_sheets.h"

#include <utility>

#include "smore/common/parallel_for.h"

namespace smore {
namespace {

// Chosen by the log scores of the maps of recorded trials (docs/research_notes.md, sheets): sheets
// go on to so many times the longest patch, and the thinnest has this share of the balls' diameter.
constexpr double kFarther = 2.0;
constexpr double kThinnest = 0.04;

// Independent of the order of the radii.
int orderOfThickness(int hypothesis) { return (29 * hypothesis + 17) % kHypotheses; }

}  // namespace

bool SurfaceSheet::reaches(const Eigen::Vector3f& offset) const {
  const float along = offset.dot(normal);
  return offset.squaredNorm() - along * along <= radius * radius && cells.hold(offset);
}

WorldSheets::WorldSheets(TouchedByHypothesis touched, MatterLimits limits,
                         const FeatureParameters& feature, const ExtentParameters& extent,
                         std::uint64_t seed)
    : known_(std::make_shared<const Known>(
          Known{std::move(touched), std::move(limits), feature, extent, seed})) {}

SheetsByHypothesis WorldSheets::all() const {
  SheetsByHypothesis sheets;
  if (!known_) return sheets;
  parallelFor(kHypotheses,
              [&](std::size_t i) { sheets[i] = sheetsOf(*known_, static_cast<int>(i)); });
  return sheets;
}

std::vector<SurfaceSheet> WorldSheets::sheetsOf(const Known& known, int hypothesis) {
  const MatterAllowed allowed =
      known.limits.allowedFor(hypothesis, MatterLimits::Known::kIsNotTouched);
  const double longest = kFarther * known.extent.world_longest;
  const double deepest = 2.0 * known.feature.radius;
  const double thickness =
      sizeOfHypothesis(orderOfThickness(hypothesis), kThinnest * deepest, deepest);
  std::vector<SurfaceSheet> sheets;
  for (TouchedPatch at : known.touched[hypothesis]) {
    SurfacePatch& patch = at.patch;
    patch.radius = static_cast<float>(sizeOfHypothesis(hypothesis, known.extent.shortest, longest));
    CounterRandom random(mixBits(at.id, mixBits(known.seed, hypothesis)));
    const auto to_surface = static_cast<float>(known.feature.radius);
    sheets.push_back({patch.center + to_surface * patch.normal, patch.normal, patch.radius,
                      static_cast<float>(thickness), PatchCells(patch, allowed, &random)});
  }
  return sheets;
}

}  // namespace smore
