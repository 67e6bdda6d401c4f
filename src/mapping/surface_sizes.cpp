// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_sizes.h"

#include <algorithm>
#include <cmath>

#include "smore/mapping/log_probabilities.h"

namespace smore {
namespace {

using Sizes = std::array<double, kHypotheses>;

// For each size, how flat surfaces would be that join the touch to the others within that size: the
// kernel without what it falls by along a surface.
Sizes flatnessWithin(const SurfaceTouch& touch, const std::vector<SurfaceTouch>& touches,
                     const Sizes& sizes, const AttractionKernel& kernel) {
  Sizes flatness{};
  for (const SurfaceTouch& other : touches) {
    if (&other == &touch) continue;
    const Eigen::Vector3f between = touch.place - other.place;
    const auto first = std::upper_bound(sizes.begin(), sizes.end(), between.norm()) - sizes.begin();
    if (first == kHypotheses) continue;
    const float height = touch.normal.dot(between);
    const float other_height = other.normal.dot(between);
    flatness[first] += kernel.of(0.0F, height * height + other_height * other_height);
  }
  for (int i = 1; i < kHypotheses; ++i) flatness[i] += flatness[i - 1];
  return flatness;
}

std::vector<SurfaceTouch> touchesInWorld(const std::vector<ContactHypotheses>& contacts,
                                         const Explanation& explanation) {
  std::vector<SurfaceTouch> touches;
  touches.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const int place = explanation[k];
    if (place == kFalseContact) continue;
    touches.push_back({contacts[k].world.at(place), contacts[k].world_normal.at(place)});
  }
  return touches;
}

}  // namespace

std::array<double, kHypotheses> surfaceSizes(double shortest, double longest) {
  Sizes sizes{};
  for (int i = 0; i < kHypotheses; ++i) {
    sizes[i] = shortest * std::pow(longest / shortest, (i + 0.5) / kHypotheses);
  }
  return sizes;
}

std::array<double, kHypotheses> sizeProbabilities(const std::vector<SurfaceTouch>& touches,
                                                  const std::array<double, kHypotheses>& sizes,
                                                  const AttractionParameters& attraction) {
  const AttractionKernel kernel(attraction);
  // Of discs of all sizes together, each as dense as its area is small, the mean is (h / d)^2.
  const double discs = 2.0 * std::log(sizes.back() / sizes.front());
  Sizes log_likelihood{};
  for (const SurfaceTouch& touch : touches) {
    const Sizes flatness = flatnessWithin(touch, touches, sizes, kernel);
    for (int i = 0; i < kHypotheses; ++i) {
      const double density = discs * std::pow(attraction.scale / sizes[i], 2);
      log_likelihood[i] += std::log1p(density * flatness[i] / attraction.base);
    }
  }
  exponentiate(&log_likelihood);
  return log_likelihood;
}

HypothesisWeights::Weights weightsBySize(const std::vector<ContactHypotheses>& contacts,
                                         const std::vector<Explanation>& explanations,
                                         const std::array<double, kHypotheses>& sizes,
                                         const AttractionParameters& attraction) {
  Sizes weights{};
  for (int m = 0; m < kHypotheses; ++m) {
    weights[m] = sizeProbabilities(touchesInWorld(contacts, explanations[m]), sizes, attraction)[m];
  }
  return weights;
}

}  // namespace smore
