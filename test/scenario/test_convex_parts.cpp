// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "meshes.h"
#include "smore/common/result.h"
#include "smore/scenario/mesh.h"
#include "smore/scenario/scenario.h"
#include "smore/scenario/tessellation.h"
#include "temporary_directory.h"

namespace smore {
namespace {

/// Loads the mesh as the object of a scenario.
class ConvexParts : public testing::Test {
 protected:
  MeshShape object(const std::string& obj) {
    directory_.write("object.obj", obj);
    const std::string file = directory_.write("scene.yaml", R"(
{name: x, task: retrieve, voxel_size: 0.03, motion: planar, robot: cartesian,
 object: {shapes: [{type: mesh, file: object.obj, position: [0, 0, 0]}]},
 environment: {shapes: [{type: sphere, radius: 0.1, position: [9, 0, 0]}]},
 start: {position: [0, 0, 0]}, goal: {position: [1, 0, 0]},
 workspace: {min: [-1, -1, 0], max: [1, 1, 0]}})");
    return std::get<MeshShape>(loadScenario(file).object[0].geometry);
  }

  TemporaryDirectory directory_;
};

std::vector<Shape> solidsOf(const MeshShape& mesh) {
  std::vector<Shape> solids;
  for (const ConvexPart& part : mesh.parts) {
    MeshShape solid;
    solid.vertices = part.vertices;
    solid.triangles = part.triangles;
    solids.push_back({solid, Pose::Identity()});
  }
  return solids;
}

TEST_F(ConvexParts, ofBarsAreTheBars) {
  // The S-shape of the reference scene as one polygon: five bars.
  const MeshShape s = object(prismObj({{-0.15, 0.03},
                                       {-0.15, 0.27},
                                       {0.21, 0.27},
                                       {0.21, 0.33},
                                       {-0.21, 0.33},
                                       {-0.21, -0.03},
                                       {0.15, -0.03},
                                       {0.15, -0.27},
                                       {-0.21, -0.27},
                                       {-0.21, -0.33},
                                       {0.21, -0.33},
                                       {0.21, 0.03}},
                                      0.06, true));
  EXPECT_EQ(s.parts.size(), 5u);
  EXPECT_LT(s.parts_error, 1e-6);
  double volume = 0.0;
  for (const Shape& solid : solidsOf(s)) {
    EXPECT_TRUE(isConvex(std::get<MeshShape>(solid.geometry)));
    volume += std::abs(signedVolume(std::get<MeshShape>(solid.geometry)));
  }
  EXPECT_GE(volume, signedVolume(s) - 1e-9) << "the parts cover the solid";
}

// Few large triangles, and cut at other diagonals where it is mirrored.
TEST_F(ConvexParts, ofMirroredBarsAreTheBarsToo) {
  for (const double mirrored : {1.0, -1.0}) {
    const double w = 0.05 * mirrored;
    std::vector<Eigen::Vector2d> u = {{-w, -0.05},      {w, -0.05},       {w, 0.05},
                                      {0.6 * w, 0.05},  {0.6 * w, -0.03}, {-0.6 * w, -0.03},
                                      {-0.6 * w, 0.05}, {-w, 0.05}};
    std::vector<Eigen::Vector2d> l = {{-w, -0.05},       {w, -0.05},       {w, -0.04},
                                      {-0.8 * w, -0.04}, {-0.8 * w, 0.05}, {-w, 0.05}};
    for (auto* outline : {&u, &l}) {
      if (mirrored < 0.0) std::reverse(outline->begin(), outline->end());
      const MeshShape mesh = object(prismObj(*outline, 0.02, true));
      EXPECT_GE(mesh.parts.size(), 2u);
      EXPECT_LT(mesh.parts_error, 0.001);
    }
  }
}

TEST_F(ConvexParts, aConvexMeshHasNone) { EXPECT_TRUE(object(cubeObj()).parts.empty()); }

// A rod that is 400 times as long as thick, bent a little so that its hull does not serve, of more
// triangles than are cut: where they are made fewer, corners of one cross-section become one.
TEST_F(ConvexParts, ofAFineThreadAreRefusedWithARemedy) {
  constexpr int kSides = 24;
  constexpr int kRings = 60;
  std::ostringstream text;
  text.precision(17);
  for (int ring = 0; ring < kRings; ++ring) {
    const double along = static_cast<double>(ring) / (kRings - 1);
    const double bend = 2e-4 * std::sin(M_PI * along);
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2.0 * M_PI * side / kSides;
      text << "v " << 0.0005 * std::cos(angle) + bend << " " << 0.0005 * std::sin(angle) << " "
           << 0.4 * along << "\n";
    }
  }
  for (int ring = 0; ring + 1 < kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      const int a = ring * kSides + side + 1;
      const int b = ring * kSides + (side + 1) % kSides + 1;
      text << "f " << a << " " << b << " " << b + kSides << " " << a + kSides << "\n";
    }
  }
  // Ends of triangles: assimp 5.4 leaves out polygons of a millimetre with more than four corners.
  constexpr int kLast = (kRings - 1) * kSides;
  for (int side = 2; side < kSides; ++side) {
    text << "f 1 " << side + 1 << " " << side << "\n"
         << "f " << kLast + 1 << " " << kLast + side << " " << kLast + side + 1 << "\n";
  }
  try {
    object(text.str());
    FAIL() << "taken";
  } catch (const InputError& problem) {
    EXPECT_NE(std::string(problem.what()).find("give it with 2000 at most"), std::string::npos)
        << problem.what();
  }
}

std::string objOf(const MeshShape& mesh) {
  std::ostringstream text;
  for (const Vec3& v : mesh.vertices) text << "v " << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) {
    text << "f " << (t + Eigen::Vector3i::Ones()).transpose() << "\n";
  }
  return text.str();
}

// Too fine for a hull, and as it is round without flat faces that could be joined.
TEST_F(ConvexParts, ofAFineEggAreOne) {
  MeshShape egg = tessellate({SphereShape{0.1}, Pose::Identity()});
  for (Vec3& vertex : egg.vertices) vertex.z() *= 1.5;
  ASSERT_GT(egg.triangles.size(), 2000u);
  const MeshShape loaded = object(objOf(egg));
  EXPECT_EQ(loaded.parts.size(), 1u);
  EXPECT_LT(loaded.parts_error, 0.003) << "of an egg 30 cm long";
}

// A hollow ball with an opening: 9,000 triangles, made coarser before they are cut.
TEST_F(ConvexParts, ofAFineBowlAreNearItAndQuick) {
  MeshShape bowl = tessellate({SphereShape{0.1}, Pose::Identity()});
  for (Vec3& vertex : bowl.vertices) {
    if (vertex.z() > 1e-9) vertex.z() *= -0.8;
  }
  const std::clock_t begin = std::clock();
  const MeshShape loaded = object(objOf(bowl));
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10.0);
  EXPECT_GT(loaded.parts.size(), 5u);
  EXPECT_GT(loaded.parts_error, 0.0);
  EXPECT_LT(loaded.parts_error, 0.02) << "of a bowl 20 cm wide";
  const std::vector<Shape> solids = solidsOf(loaded);
  EXPECT_GT(signedDistance(solids, Vec3(0, 0, -0.04)), 0.0) << "the hollow is free";
  for (const Shape& solid : solids) {
    for (const Vec3& vertex : std::get<MeshShape>(solid.geometry).vertices) {
      EXPECT_LE(signedDistance({{loaded, Pose::Identity()}}, vertex), loaded.parts_error + 1e-9);
    }
  }
}

}  // namespace
}  // namespace smore
