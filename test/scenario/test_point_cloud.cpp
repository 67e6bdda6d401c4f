// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "../common/refusal.h"
#include "smore/common/result.h"
#include "smore/scenario/point_cloud.h"
#include "temporary_directory.h"

namespace smore {
namespace {

template <typename T>
std::string bytesOf(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

const char* const kPlyHead =
    "ply\nformat binary_little_endian 1.0\ncomment from a camera\nelement vertex 2\n"
    "property double x\nproperty uchar red\nproperty float y\nproperty float z\n"
    "element face 0\nproperty list uchar int vertex_indices\nend_header\n";

std::string binaryPly() {
  return kPlyHead + bytesOf(0.5) + "r" + bytesOf(1.5F) + bytesOf(-2.0F) + bytesOf(1.0) + "r" +
         bytesOf(std::nanf("")) + bytesOf(0.0F);
}

std::string pcdHead(const std::string& data) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS rgb normal x y z\nSIZE 4 4 4 4 4\nTYPE U F F F F\n"
         "COUNT 1 2 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
         data + "\n";
}

class PointCloud : public testing::Test {
 protected:
  std::vector<Vec3> load(const std::string& content) {
    return loadPointCloud(directory_.write("some.cloud", content));
  }
  std::string problemOf(const std::string& content) {
    return refusalOf([&] { return load(content); });
  }
  TemporaryDirectory directory_;
};

TEST_F(PointCloud, ReadsBinaryPlyAndLeavesOutWhatWasNotSeen) {
  const auto points = load(binaryPly());
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0], Vec3(0.5, 1.5, -2.0));
}

TEST_F(PointCloud, ReadsPcdInTextAndBinary) {
  const auto text = load(pcdHead("ascii") + "7 0 0 1 2 3\n7 0 0 nan 2 3\n");
  ASSERT_EQ(text.size(), 1U);
  EXPECT_EQ(text[0], Vec3(1, 2, 3));
  std::string binary = pcdHead("binary");
  for (int i = 0; i < 2; ++i) {
    binary += bytesOf(std::uint32_t{7}) + bytesOf(0.0F) + bytesOf(0.0F);
    for (const float coordinate : {1.0F, 2.0F, 3.0F + static_cast<float>(i)}) {
      binary += bytesOf(coordinate);
    }
  }
  const auto points = load(binary);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1], Vec3(1, 2, 4));
}

TEST_F(PointCloud, SaysWhatIsWrong) {
  EXPECT_NE(problemOf(pcdHead("binary_compressed")).find("ascii or binary"), std::string::npos);
  EXPECT_NE(problemOf(pcdHead("ascii") + "7 0 0 1 2 3\n").find("1 of 2"), std::string::npos);
  EXPECT_NE(problemOf("solid\n").find("no DATA"), std::string::npos);
  EXPECT_NE(problemOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n")
                .find("without y"),
            std::string::npos);
  EXPECT_THROW(loadPointCloud("/nowhere/cloud.ply"), InputError);
}

TEST_F(PointCloud, PlyFilesWithFacesAreMeshes) {
  EXPECT_FALSE(hasFaces(directory_.write("a.ply", binaryPly())));
  std::string mesh = binaryPly();
  mesh.replace(mesh.find("face 0"), 6, "face 2");
  EXPECT_TRUE(hasFaces(directory_.write("b.ply", mesh)));
}

TEST_F(PointCloud, SurvivesAnyDamage) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    std::string content =
        i % 2 == 0 ? binaryPly() : pcdHead("ascii") + "7 0 0 1 2 3\n7 0 0 1 1 3\n";
    for (int k = 0; k <= i % 3; ++k) {
      content[random() % content.size()] = static_cast<char>(random());
    }
    content.resize(content.size() - random() % 4);
    try {
      for (const Vec3& point : load(content)) ASSERT_TRUE(point.allFinite());
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()), "");
    }
  }
}

// Each would be zeros, or another number, to a reader that does not look.
TEST_F(PointCloud, WordsThatAreNoNumbersAreRefused) {
  EXPECT_NE(problemOf(pcdHead("ascii") + "7 0 0 a b c\n7 0 0 1 2 3\n").find("'a' of a point"),
            std::string::npos);
  EXPECT_NE(problemOf(pcdHead("ascii") + "7 0 0 0,2 1 1\n7 0 0 1 2 3\n").find("decimal points"),
            std::string::npos);
  std::string head = pcdHead("ascii");
  head.replace(head.find("POINTS 2"), 8, "POINTS 2e0");
  EXPECT_NE(problemOf(head + "7 0 0 1 2 3\n").find("'2e0' is no number"), std::string::npos);
}

}  // namespace
}  // namespace smore
