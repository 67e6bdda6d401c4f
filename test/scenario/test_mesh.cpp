// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "meshes.h"
#include "smore/common/result.h"
#include "smore/scenario/mesh.h"
#include "temporary_directory.h"

namespace smore {
namespace {

std::string asciiStl(const MeshShape& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "solid test\n";
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    text << "facet normal 0 0 0\n outer loop\n";
    for (const int index : triangle) {
      text << "  vertex " << mesh.vertices[static_cast<size_t>(index)].transpose() << "\n";
    }
    text << " endloop\nendfacet\n";
  }
  return text.str() + "endsolid test\n";
}

template <typename T>
void append(std::string* bytes, T value) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string binaryStl(const MeshShape& mesh) {
  std::string bytes = "solid, though binary";
  bytes.resize(80, ' ');
  append(&bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(&bytes, 0.0F);
    for (const int index : triangle) {
      for (const double x : mesh.vertices[static_cast<size_t>(index)]) {
        append(&bytes, static_cast<float>(x));
      }
    }
    append(&bytes, static_cast<std::uint16_t>(0));
  }
  return bytes;
}

class MeshTest : public testing::Test {
 protected:
  MeshShape load(const std::string& name, const std::string& content,
                 const Vec3& scale = Vec3::Ones()) {
    return loadMesh(directory_.write(name, content), scale);
  }

  std::string problemOf(const std::string& name, const std::string& content) {
    try {
      load(name, content);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryDirectory directory_;
};

TEST_F(MeshTest, allFormatsGiveTheSameSolid) {
  const MeshShape cube = load("cube.obj", cubeObj());
  for (const std::string& content : {asciiStl(cube), binaryStl(cube)}) {
    const MeshShape again = load("cube.stl", content);
    EXPECT_EQ(again.vertices.size(), 8u);
    EXPECT_EQ(again.triangles.size(), 12u);
    EXPECT_NEAR(signedVolume(again), 1.0, 1e-12);
  }
}

TEST_F(MeshTest, negativeObjIndicesAndTextureIndicesMeanTheSame) {
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f -4/1 -2/1 -3/1\nf 1//7 2//7 4//7\nf 2 3 4\nf 1 4 3\n";
  EXPECT_NEAR(signedVolume(load("t.obj", tetrahedron + faces)), 1.0 / 6.0, 1e-12);
}

TEST_F(MeshTest, mirroredMeshesAreTurnedOutsideOut) {
  const MeshShape cube = load("cube.obj", cubeObj(), Vec3(-2.0, 1.0, 0.5));
  EXPECT_NEAR(signedVolume(cube), 1.0, 1e-12);
  EXPECT_NEAR(signedDistance(cube, Vec3(-1.0, 0.5, 0.25)), -0.25, 1e-12);
}

TEST_F(MeshTest, tellsConvexFromConcave) {
  EXPECT_TRUE(isConvex(load("cube.obj", cubeObj())));
  EXPECT_FALSE(isConvex(load("ell.obj", ellObj())));
}

TEST_F(MeshTest, distanceOfACubeIsThatOfABox) {
  const MeshShape cube = load("cube.obj", cubeObj());
  const Shape box{BoxShape{Vec3::Ones()}, makePose(Vec3::Constant(0.5))};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.7, 1.7);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 point(uniform(random), uniform(random), uniform(random));
    EXPECT_NEAR(signedDistance(cube, point), signedDistance({box}, point), 1e-9);
  }
}

TEST_F(MeshTest, distanceOfAConcaveMeshHasTheRightSign) {
  const MeshShape ell = load("ell.obj", ellObj());
  const std::vector<Shape> boxes{{BoxShape{Vec3(1, 2, 1)}, makePose(Vec3(0.5, 1.0, 0.5))},
                                 {BoxShape{Vec3(2, 1, 1)}, makePose(Vec3(1.0, 0.5, 0.5))}};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-0.5, 2.5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 point(uniform(random), uniform(random), uniform(random));
    const double expected = signedDistance(boxes, point);
    EXPECT_EQ(signedDistance(ell, point) < 0.0, expected < 0.0);
    if (expected > 0.0) {
      EXPECT_NEAR(signedDistance(ell, point), expected, 1e-9);
    }
  }
}

TEST_F(MeshTest, problemsNameFileAndRemedy) {
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nf 1 2 3\n").find("no vertex '2'"), std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 zero 0\n").find("line 1: expected three coordinates"),
            std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n").find("line 3"), std::string::npos);
  EXPECT_NE(problemOf("x.obj", "# empty\n").find("no triangles"), std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("not closed"),
            std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n").find("no volume"),
            std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 nan\n").find("line 1"), std::string::npos);
  EXPECT_NE(problemOf("x.stl", "not a mesh").find("neither STL nor OBJ"), std::string::npos);
  const std::string binary = binaryStl(load("cube.obj", cubeObj())) + "x";
  EXPECT_NE(problemOf("x.stl", binary).find("x.stl"), std::string::npos);
  EXPECT_THROW(loadMesh(directory_.path() + "/missing.stl", Vec3::Ones()), InputError);
}

}  // namespace
}  // namespace smore
