// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/mapping/surface_patch.h"

namespace smore {
namespace {

bool everywhere(const Eigen::Vector3f& /*point*/) { return true; }

SurfacePatch patchOf(float radius) {
  SurfacePatch patch;
  patch.center = {0.1F, 0.2F, 0.0F};
  patch.normal = {0.6F, 0.8F, 0.0F};
  patch.radius = radius;
  patch.step = 0.02F;
  return patch;
}

TEST(SurfacePatch, InThePlaneItIsThePartOfTheTangentWithinTheRadius) {
  const SurfacePatch patch = patchOf(0.1F);
  CounterRandom random(1);
  const auto points = growPatch(patch, true, everywhere, &random);
  EXPECT_EQ(points.size(), 10U);  // five steps to either side
  for (const Eigen::Vector3f& point : points) {
    EXPECT_NEAR((point - patch.center).dot(patch.normal), 0.0F, 1e-6F);
    EXPECT_EQ(point.z(), 0.0F);
    EXPECT_LE((point - patch.center).norm(), patch.radius + 1e-6F);
  }
}

TEST(SurfacePatch, InThePlaneMatterGoesOnBehindItToItsDepth) {
  SurfacePatch patch = patchOf(0.1F);
  patch.depth = 3;
  CounterRandom random(1);
  const auto points = growPatch(patch, true, everywhere, &random);
  EXPECT_EQ(points.size(), 11U * 4U - 1U);  // the tangent and three rows behind it
  for (const Eigen::Vector3f& point : points) {
    const float behind = -(point - patch.center).dot(patch.normal);
    EXPECT_GE(behind, -1e-6F);
    EXPECT_LE(behind, 3.0F * patch.step + 1e-6F);
  }
}

TEST(SurfacePatch, MatterBehindTheCentreEndsWhereItIsNotAllowed) {
  for (const int deep : {1, 5, 100}) {
    SurfacePatch patch = patchOf(0.1F);
    patch.depth = deep;
    EXPECT_EQ(depthBehind(patch, everywhere), deep);
    for (int end = 0; end < deep; ++end) {
      const auto for_a_while = [&](const Eigen::Vector3f& point) {
        const float behind = -(point - patch.center).dot(patch.normal);
        return behind < (static_cast<float>(end) + 0.5F) * patch.step;
      };
      EXPECT_EQ(depthBehind(patch, for_a_while), end);
    }
  }
}

TEST(SurfacePatch, InSpaceItCoversADisc) {
  const SurfacePatch patch = patchOf(0.2F);
  CounterRandom random(1);
  const auto points = growPatch(patch, false, everywhere, &random);
  // As many as the disc's area has cells; its rim is ragged by a cell's width at most.
  const double cells = M_PI * std::pow(patch.radius / patch.step, 2);
  EXPECT_NEAR(static_cast<double>(points.size()), cells, 2.0 * M_PI * patch.radius / patch.step);
  for (const Eigen::Vector3f& point : points) {
    EXPECT_NEAR((point - patch.center).dot(patch.normal), 0.0F, 1e-6F);
    EXPECT_LE((point - patch.center).norm(), patch.radius + 1e-6F);
  }
}

// Beyond what free space ends there is no surface, even where free space says nothing of it.
TEST(SurfacePatch, EndsWhereMatterIsNotAllowed) {
  const SurfacePatch patch = patchOf(0.2F);
  const Eigen::Vector3f across(-patch.normal.y(), patch.normal.x(), 0.0F);
  const auto place = [&](const Eigen::Vector3f& point) {
    return (point - patch.center).dot(across);
  };
  for (const bool planar : {true, false}) {
    CounterRandom random(2);
    const auto points = growPatch(
        patch, planar,
        [&](const Eigen::Vector3f& point) {
          return place(point) < 0.05F || place(point) > 0.09F;  // a band that is wider than a step
        },
        &random);
    ASSERT_FALSE(points.empty());
    for (const Eigen::Vector3f& point : points) EXPECT_LT(place(point), 0.05F) << planar;
  }
}

TEST(SurfacePatch, APatchBelowOneStepIsItsCentreAlone) {
  CounterRandom random(1);
  EXPECT_TRUE(growPatch(patchOf(0.015F), false, everywhere, &random).empty());
}

}  // namespace
}  // namespace smore
