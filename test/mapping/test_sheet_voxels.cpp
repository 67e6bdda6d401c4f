// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "smore/mapping/sheet_voxels.h"

namespace smore {
namespace {

constexpr double kVoxel = 0.03;

bool everywhere(const Eigen::Vector3f& /*point*/) { return true; }

Vec3 anyDirection(CounterRandom* random) {
  return Vec3(random->normal(), random->normal(), random->normal()).normalized();
}

Pose anyPose(CounterRandom* random) {
  Pose T = Pose::Identity();
  T.rotate(Eigen::AngleAxisd(M_PI * random->symmetric(), anyDirection(random)));
  T.pretranslate(random->inCube());
  return T;
}

SurfaceSheet sheetOf(const Vec3& touched, const Vec3& normal, double radius, double thickness,
                     const MatterAllowed& allowed = everywhere) {
  SurfacePatch patch;
  patch.center = touched.cast<float>();
  patch.normal = normal.cast<float>();
  patch.radius = static_cast<float>(radius);
  patch.step = 0.05F;
  CounterRandom random(1);
  return {patch.center, patch.normal, patch.radius, static_cast<float>(thickness),
          PatchCells(patch, allowed, &random)};
}

std::set<VoxelKey> visited(const SurfaceSheet& sheet, const Pose& T_grid_sheet) {
  std::set<VoxelKey> keys;
  visitSheet(sheet, T_grid_sheet, kVoxel, [&](const VoxelKey& key) { keys.insert(key); });
  return keys;
}

// By its definition, of all voxels around; nothing where rounding decides.
void expectVisited(const SurfaceSheet& sheet, const Pose& T_grid_sheet) {
  const std::set<VoxelKey> keys = visited(sheet, T_grid_sheet);
  const Vec3 normal = sheet.normal.cast<double>();
  const Vec3 middle = sheet.touched.cast<double>() - 0.5 * sheet.thickness * normal;
  const Vec3 around = T_grid_sheet * middle;
  const Vec3 reach = Vec3::Constant(sheet.radius + sheet.thickness + 3.0 * kVoxel);
  const VoxelKey of_middle = voxelAt(around, kVoxel);
  visitVoxels(
      voxelAt(around - reach, kVoxel), voxelAt(around + reach, kVoxel), [&](const VoxelKey& key) {
        const Vec3 offset = T_grid_sheet.inverse() * voxelCenter(key, kVoxel) - middle;
        const double along = std::abs(offset.dot(normal));
        const double most = 0.5 * (sheet.thickness + kVoxel);
        if (std::abs(along - most) < 1e-6 || key == of_middle) return;
        const bool covered = sheet.reaches(offset.cast<float>());
        const double beside = std::sqrt(std::max(0.0, offset.squaredNorm() - along * along));
        if (!covered && std::abs(beside - 0.5 * kVoxel) < 1e-6) return;
        const bool inside = along < most && (covered || beside < 0.5 * kVoxel);
        EXPECT_EQ(keys.count(key) > 0, inside) << offset.transpose();
      });
  EXPECT_EQ(keys.count(of_middle), 1U);
}

TEST(SheetVoxels, AreThoseToWhichTheSheetComesWithinHalfAVoxel) {
  CounterRandom random(7);
  for (int i = 0; i < 60; ++i) {
    // From far below a voxel to many of them, on whatever slope.
    const double radius = 0.001 * std::pow(400.0, random.uniform());
    const double thickness = 0.0001 * std::pow(2000.0, random.uniform());
    const SurfaceSheet sheet = sheetOf(random.inCube(), anyDirection(&random), radius, thickness);
    expectVisited(sheet, anyPose(&random));
  }
}

TEST(SheetVoxels, LieBelowTheTouchedPlaceAlongTheAxesToo) {
  for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    const SurfaceSheet sheet = sheetOf(Vec3(0.011, 0.007, 0.004), normal, 0.2, 0.09);
    expectVisited(sheet, Pose::Identity());
    double deepest = 0.0;
    for (const VoxelKey& key : visited(sheet, Pose::Identity())) {
      deepest = std::min(deepest, normal.dot(voxelCenter(key, kVoxel)));
    }
    EXPECT_NEAR(deepest, -0.09, 0.04);
  }
}

// Beyond a band that holds no matter there is none, though free space says nothing of it.
TEST(SheetVoxels, EndWhereTheMatterEnds) {
  const auto beforeTheBand = [](const Eigen::Vector3f& point) {
    return point.x() < 0.1F || point.x() > 0.2F;
  };
  const SurfaceSheet sheet = sheetOf(Vec3::Zero(), Vec3::UnitZ(), 0.5, 0.02, beforeTheBand);
  expectVisited(sheet, Pose::Identity());
  double farthest = 0.0;
  for (const VoxelKey& key : visited(sheet, Pose::Identity())) {
    farthest = std::max(farthest, voxelCenter(key, kVoxel).x());
  }
  EXPECT_GT(farthest, 0.06);
  EXPECT_LT(farthest, 0.15);
}

TEST(SheetVoxels, OutOfTheRangeOfKeysThereAreNone) {
  const SurfaceSheet sheet = sheetOf(Vec3::Zero(), Vec3::UnitZ(), 0.2, 0.02);
  EXPECT_TRUE(visited(sheet, Pose(Eigen::Translation3d(0.0, kVoxel * 32765.0, 0.0))).empty());
}

}  // namespace
}  // namespace smore
