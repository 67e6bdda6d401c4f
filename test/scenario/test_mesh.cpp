// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "../common/refusal.h"
#include "meshes.h"
#include "smore/scenario/mesh.h"
#include "smore/scenario/tessellation.h"
#include "temporary_directory.h"

namespace smore {
namespace {

double distanceTo(const MeshShape& mesh, const Vec3& point) {
  return signedDistance({{mesh, Pose::Identity()}}, point);
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
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 vertex = vertexAt(mesh, triangle[corner]);
      for (int axis = 0; axis < 3; ++axis) append(&bytes, static_cast<float>(vertex[axis]));
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
    return refusalOf([&] { return load(name, content); });
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
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\n";
  const std::string faces = "f -4/1 -2/1 -3/1\nf 1//1 2//1 4//1\nf 2 3 4\nf 1 4 3\n";
  EXPECT_NEAR(signedVolume(load("t.obj", tetrahedron + faces)), 1.0 / 6.0, 1e-7);
}

TEST_F(MeshTest, seamsOfNormalsMaterialsAndGroupsAreClosed) {
  std::string faceted = "vn 0 0 1\nvn 1 0 0\nvn 0 1 0\nvt 0 0\nvt 1 1\n";
  std::istringstream lines(cubeObj());
  int face = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == 'v') faceted += line + "\n";
    if (line[0] != 'f') continue;
    std::istringstream words(line.substr(1));
    faceted += (face % 2 == 0 ? "g even\nusemtl red\nf" : "o odd\nusemtl blue\nf");
    const std::string attributes =
        "/" + std::to_string(1 + face % 2) + "/" + std::to_string(1 + face % 3);
    for (std::string word; words >> word;) faceted += " " + word + attributes;
    faceted += "\n";
    ++face;
  }
  const MeshShape cube = load("cube.obj", faceted);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_NEAR(signedVolume(cube), 1.0, 1e-12);
}

TEST_F(MeshTest, plyAndColladaFilesAreRead) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string ply =
      header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  EXPECT_NEAR(signedVolume(load("t.ply", ply)), 1.0 / 6.0, 1e-7);
  // In millimetres, z up, moved by its node: what stands in the file, in metres.
  const MeshShape collada = load("t.DAE", R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="12">0 0 0 1000 0 0 0 1000 0 0 0 2000</float_array>
   <technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
    <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
  </source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
   <p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node><translate>0 0 500</translate>
  <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)");
  const Bounds bounds = boundsOf({{collada, Pose::Identity()}});
  EXPECT_LT((bounds.min - Vec3(0, 0, 0.5)).norm(), 1e-6);
  EXPECT_LT((bounds.max - Vec3(1, 1, 2.5)).norm(), 1e-6);
}

TEST_F(MeshTest, concavePolygonsAreCutWithinTheirOutline) {
  for (const std::string name : {"u_plate", "u_plate_from_notch", "u_plate_triangulated"}) {
    const MeshShape plate =
        loadMesh(SMORE_SOURCE_DIR "/test/data/cases/ngon/" + name + ".obj", Vec3::Ones());
    EXPECT_NEAR(signedVolume(plate), 0.002, 1e-8) << name;  // 0.1 m^2, 2 cm thick
    EXPECT_FALSE(isConvex(plate));
    EXPECT_NEAR(distanceTo(plate, Vec3(0, 0.05, 0)), 0.1, 1e-6) << name << ": the notch is free";
    EXPECT_NEAR(distanceTo(plate, Vec3(0, -0.15, 0)), -0.01, 1e-6) << name;
  }
}

TEST_F(MeshTest, aMeshInMillimetresIsToldWithTheScaleToTry) {
  const std::string problem = problemOf("big.obj", prismObj({{0, 0}, {420, 0}, {0, 60}}, 60.0));
  EXPECT_NE(problem.find("big.obj: 420 m large, above 100 m; looks like millimetres; "
                         "scale: [0.001, 0.001, 0.001]"),
            std::string::npos)
      << problem;
  const std::string small = directory_.write("mug.obj", prismObj({{0, 0}, {80, 0}, {0, 60}}, 60.0));
  EXPECT_NO_THROW(loadMesh(small, Vec3::Ones()));  // of a scene it might be
  EXPECT_THROW(loadMesh(small, Vec3::Ones(), kLargestHeld), InputError);
  EXPECT_NE(problemOf("far.obj", prismObj({{900, 0}, {901, 0}, {900, 1}}, 1.0)).find("own origin"),
            std::string::npos);
}

TEST_F(MeshTest, mirroredMeshesAreTurnedOutsideOut) {
  const MeshShape cube = load("cube.obj", cubeObj(), Vec3(-2.0, 1.0, 0.5));
  EXPECT_NEAR(signedVolume(cube), 1.0, 1e-12);
  EXPECT_NEAR(distanceTo(cube, Vec3(-1.0, 0.5, 0.25)), -0.25, 1e-12);
}

TEST_F(MeshTest, tellsConvexFromConcave) {
  EXPECT_TRUE(isConvex(load("cube.obj", cubeObj())));
  EXPECT_FALSE(isConvex(load("ell.obj", ellObj())));
}

// Corners of a regular prism's cap, some of them so close that the faces between are slivers.
std::vector<Eigen::Vector2d> unevenCircle(double radius, int corners, std::mt19937* random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    if (uniform(*random) < 0.3) {
      const double sliver = angle + std::pow(10.0, -2.0 - 3.0 * uniform(*random));
      outline.emplace_back(radius * std::cos(sliver), radius * std::sin(sliver));
    }
  }
  return outline;
}

std::string obj(const MeshShape& mesh) {
  std::string text;
  std::array<char, 100> line{};
  for (const Vec3& v : mesh.vertices) {
    std::snprintf(line.data(), line.size(), "v %.6f %.6f %.6f\n", v.x(), v.y(), v.z());
    text += line.data();
  }
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::snprintf(line.data(), line.size(), "f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line.data();
  }
  return text;
}

void turn(MeshShape* mesh, const Vec3& rpy) {
  const Pose pose = makePose(Vec3::Zero(), rpy);
  for (Vec3& vertex : mesh->vertices) vertex = pose * vertex;
}

// Exporters write OBJ with six decimals, STL with 32-bit floats or seven digits.
TEST_F(MeshTest, convexSolidsStayConvexHoweverFilesRoundThem) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const double radius = std::pow(10.0, -2.0 + 1.5 * uniform(random));
    const int corners = 3 + static_cast<int>(uniform(random) * 64);
    MeshShape prism = load("exact.obj", prismObj(unevenCircle(radius, corners, &random),
                                                 radius * (0.2 + 5.0 * uniform(random))));
    turn(&prism, Vec3(uniform(random), uniform(random), uniform(random)) * 3.0);
    EXPECT_TRUE(isConvex(load("rounded.obj", obj(prism)))) << i;
    EXPECT_TRUE(isConvex(load("rounded.stl", binaryStl(prism)))) << i;
    EXPECT_TRUE(isConvex(load("digits.stl", asciiStl(prism, 7)))) << i;
  }
}

TEST_F(MeshTest, aDentOfAHundredthIsConcave) {
  std::mt19937 random(4);
  for (int corners : {6, 20, 60}) {
    MeshShape prism = load("prism.obj", prismObj(unevenCircle(0.1, corners, &random), 0.1));
    turn(&prism, Vec3(0.3, 0.5, 0.2));
    ASSERT_TRUE(isConvex(prism));
    prism.vertices[0] *= 0.98;  // a corner of the cap
    EXPECT_FALSE(isConvex(prism)) << corners;
  }
}

// A bowl: every edge is nearly flat, the whole is far from convex.
TEST_F(MeshTest, aFineHollowIsConcave) {
  MeshShape ball = tessellate({SphereShape{0.1}, Pose::Identity()});
  EXPECT_TRUE(isConvex(ball));
  for (Vec3& vertex : ball.vertices) {
    if (vertex.z() > 0.0) vertex.z() *= -0.9;
  }
  EXPECT_FALSE(isConvex(ball));
}

TEST_F(MeshTest, distanceOfACubeIsThatOfABox) {
  const MeshShape cube = load("cube.obj", cubeObj());
  const Shape box{BoxShape{Vec3::Ones()}, makePose(Vec3::Constant(0.5))};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.7, 1.7);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 point(uniform(random), uniform(random), uniform(random));
    EXPECT_NEAR(distanceTo(cube, point), signedDistance({box}, point), 1e-9);
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
    EXPECT_EQ(distanceTo(ell, point) < 0.0, expected < 0.0);
    if (expected > 0.0) {
      EXPECT_NEAR(distanceTo(ell, point), expected, 1e-9);
    }
  }
}

TEST_F(MeshTest, problemsNameFileAndRemedy) {
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nf 1 2 3\n").find("x.obj: cannot be read as a mesh"),
            std::string::npos);
  EXPECT_NE(problemOf("x.obj", "# empty\n").find("x.obj: "), std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("not closed"),
            std::string::npos);
  EXPECT_NE(problemOf("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n").find("no volume"),
            std::string::npos);
  EXPECT_NE(problemOf("x.stl", "not a mesh").find("cannot be read as a mesh"), std::string::npos);
  const std::string binary = binaryStl(load("cube.obj", cubeObj()));
  EXPECT_NE(problemOf("x.stl", binary.substr(0, binary.size() - 60)).find("x.stl"),
            std::string::npos);
  // The third vertex of one face of a tetrahedron is not there.
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 -2\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  EXPECT_NE(problemOf("x.ply", ply).find("vertex that is not there"), std::string::npos);
  EXPECT_NE(problemOf("x.step", "ISO-10303-21;").find("as STL, OBJ, PLY or DAE"),
            std::string::npos);
  EXPECT_NE(problemOf("gone/x.stl", "").find("there is no such file"), std::string::npos);
}

}  // namespace
}  // namespace smore
