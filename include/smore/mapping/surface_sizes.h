// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "smore/mapping/hypothesis_weights.h"
#include "smore/mapping/joint_distribution.h"

namespace smore {

/// Radii of surfaces, as many as there are hypotheses: spread evenly over all orders of magnitude
/// from `shortest` to `longest` [m], both positive.
std::array<double, kHypotheses> surfaceSizes(double shortest, double longest);

/// A touched place and the unit normal there, in one frame.
struct SurfaceTouch {
  Eigen::Vector3f place;
  Eigen::Vector3f normal;
};

/// How likely each size of the surfaces is that were touched, given where: by how well each touch
/// is foreseen by the others if surfaces go on from touches as far as that: docs/belief.md (B8).
/// The mean over all sizes of how much one touch foresees another is the AttractionKernel of
/// surfaces, at distances well above its scale; `attraction` is that of surfaces. Of sum 1; all
/// equal for less than two touches. `sizes` must not fall.
std::array<double, kHypotheses> sizeProbabilities(const std::vector<SurfaceTouch>& touches,
                                                  const std::array<double, kHypotheses>& sizes,
                                                  const AttractionParameters& attraction);

/// Weights of the hypotheses, hypothesis m having surfaces of size m in the world.
HypothesisWeights::Weights weightsBySize(const std::vector<ContactHypotheses>& contacts,
                                         const std::vector<Explanation>& explanations,
                                         const std::array<double, kHypotheses>& sizes,
                                         const AttractionParameters& attraction);

}  // namespace smore
