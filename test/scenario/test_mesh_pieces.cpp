// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "../common/refusal.h"
#include "meshes.h"
#include "smore/scenario/mesh.h"
#include "temporary_directory.h"

namespace smore {
namespace {

TEST(MeshPieces, oneInsideOutIsToldAndAHollowIsNot) {
  const TemporaryDirectory directory;
  const auto load = [&](const std::string& name, const std::string& content) {
    return loadMesh(directory.write(name, content), Vec3::Ones());
  };
  const auto problemOf = [&](const std::string& content) {
    return refusalOf([&] { return load("piece.stl", content); });
  };
  const MeshShape cube = load("cube.obj", cubeObj());
  const auto moved = [&cube](double size, const Vec3& by, bool outwards) {
    MeshShape piece = cube;
    for (Vec3& vertex : piece.vertices) vertex = size * vertex + by;
    for (Eigen::Vector3i& triangle : piece.triangles) {
      if (!outwards) std::swap(triangle[1], triangle[2]);
    }
    return piece;
  };
  const auto joined = [](const std::vector<MeshShape>& pieces) {
    std::string text;
    for (const MeshShape& piece : pieces) text += asciiStl(piece);
    return text;
  };
  const MeshShape large = moved(1.0, Vec3::Zero(), true);
  const MeshShape hollow = moved(0.5, Vec3(0.25, 0.25, 0.25), false);
  const MeshShape within_hollow = moved(0.125, Vec3(0.4, 0.4, 0.4), true);
  EXPECT_NEAR(signedVolume(load("nested.stl", joined({large, hollow, within_hollow}))),
              1.0 - 0.125 + 0.125 * 0.125 * 0.125, 1e-6);

  const Vec3 beside(2.0, 0.0, 0.0);
  EXPECT_NEAR(signedVolume(load("both.stl", joined({large, moved(0.5, beside, true)}))), 1.125,
              1e-6);
  for (const double size : {0.5, 1.5}) {  // the whole volume is positive, and negative
    const std::string problem = problemOf(joined({large, moved(size, beside, false)}));
    EXPECT_NE(problem.find("inside out"), std::string::npos) << problem;
  }
  // So is what lies in a hollow.
  EXPECT_NE(
      problemOf(joined({large, hollow, moved(0.125, Vec3(0.4, 0.4, 0.4), false)})).find("(0.4"),
      std::string::npos);
}

}  // namespace
}  // namespace smore
