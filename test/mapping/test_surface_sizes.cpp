// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "at_a_decimetre.h"
#include "smore/mapping/surface_sizes.h"

namespace smore {
namespace {

const AttractionParameters kAttraction = atADecimetre().distribution.world;

std::array<double, kHypotheses> sizes() { return surfaceSizes(0.02, 0.6); }

// Touches of one plane, evenly spread over a square.
std::vector<SurfaceTouch> touchesOfSquare(int count, float width) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-0.5F * width, 0.5F * width);
  std::vector<SurfaceTouch> touches;
  for (int i = 0; i < count; ++i) {
    touches.push_back({{uniform(random), uniform(random), 0.0F}, Eigen::Vector3f::UnitZ()});
  }
  return touches;
}

double meanLogSize(const std::array<double, kHypotheses>& probabilities) {
  double mean = 0.0;
  for (int i = 0; i < kHypotheses; ++i) mean += probabilities[i] * std::log(sizes()[i]);
  return mean;
}

double largestLikely(const std::array<double, kHypotheses>& probabilities) {
  return sizes()[std::max_element(probabilities.begin(), probabilities.end()) -
                 probabilities.begin()];
}

TEST(SurfaceSizes, AreSpreadEvenlyOverTheOrdersOfMagnitude) {
  EXPECT_NEAR(sizes()[1] / sizes()[0], sizes()[63] / sizes()[62], 1e-9);
  EXPECT_GT(sizes().front(), 0.02);
  EXPECT_LT(sizes().back(), 0.6);
}

TEST(SurfaceSizes, WithoutTwoTouchesAllAreEquallyLikely) {
  for (const int count : {0, 1}) {
    for (const double p : sizeProbabilities(touchesOfSquare(count, 1.0F), sizes(), kAttraction)) {
      EXPECT_DOUBLE_EQ(p, 1.0 / kHypotheses);
    }
  }
}

TEST(SurfaceSizes, ProbabilitiesHaveTheSumOne) {
  const auto p = sizeProbabilities(touchesOfSquare(20, 0.5F), sizes(), kAttraction);
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
}

// What is likely grows with what was touched.
TEST(SurfaceSizes, OfAWallAreLargeAndOfAPegSmall) {
  const auto of = [](float width) {
    return sizeProbabilities(touchesOfSquare(20, width), sizes(), kAttraction);
  };
  EXPECT_LT(largestLikely(of(0.05F)), 0.1);
  EXPECT_GT(largestLikely(of(1.0F)), 0.15);
  EXPECT_LT(meanLogSize(of(0.05F)), meanLogSize(of(0.25F)));
  EXPECT_LT(meanLogSize(of(0.25F)), meanLogSize(of(1.0F)));
}

TEST(SurfaceSizes, TouchesAcrossASurfaceSayNothingForIt) {
  std::vector<SurfaceTouch> stack;
  for (int i = 0; i < 6; ++i) {
    stack.push_back({{0.0F, 0.0F, 0.5F * static_cast<float>(i)}, Eigen::Vector3f::UnitZ()});
  }
  for (const double p : sizeProbabilities(stack, sizes(), kAttraction)) {
    EXPECT_NEAR(p, 1.0 / kHypotheses, 1e-4);
  }
}

// The mean of the discs' densities over all sizes is the kernel of the attraction, far from its
// scale and from the largest size.
TEST(SurfaceSizes, DiscsOfAllSizesMakeTheKernelOfTheAttraction) {
  constexpr int kNumbers = 4000;
  const AttractionKernel kernel(kAttraction);
  const double range = std::log(2.0 / 0.02);
  for (const double d : {0.15, 0.3}) {
    double mean = 0.0;
    for (int i = 0; i < kNumbers; ++i) {
      const double size = 0.02 * std::exp(range * (i + 0.5) / kNumbers);
      if (size > d) mean += 2.0 * range * std::pow(kAttraction.scale / size, 2) / kNumbers;
    }
    const Eigen::Vector3f along(static_cast<float>(d), 0.0F, 0.0F);
    EXPECT_NEAR(mean / kernel(along, Eigen::Vector3f::UnitZ(), Eigen::Vector3f::UnitZ()), 1.0,
                0.15);
  }
}

}  // namespace
}  // namespace smore
