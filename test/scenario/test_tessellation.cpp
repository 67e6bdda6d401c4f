// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "smore/scenario/mesh.h"
#include "smore/scenario/tessellation.h"

namespace smore {
namespace {

bool isClosed(const MeshShape& mesh) {
  std::map<std::pair<int, int>, int> balance;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      ++balance[{t[i], t[(i + 1) % 3]}];
      --balance[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const auto& entry : balance) {
    if (entry.second != 0) return false;
  }
  return true;
}

// A regular polygon of n corners has n/2 sin(2 pi/n) of the squared radius as its area.
TEST(Tessellation, enclosesTheVolumeOfTheSolid) {
  const Pose pose = makePose(Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3));
  const MeshShape box = tessellate({BoxShape{Vec3(1, 2, 3)}, pose});
  EXPECT_NEAR(signedVolume(box), 6.0, 1e-12);
  const MeshShape cylinder = tessellate({CylinderShape{0.5, 2.0}, pose});
  EXPECT_NEAR(signedVolume(cylinder), 48.0 * std::sin(2.0 * M_PI / 96.0) * 0.25 * 2.0, 1e-12);
  const MeshShape sphere = tessellate({SphereShape{0.5}, pose});
  EXPECT_NEAR(signedVolume(sphere), 4.0 / 3.0 * M_PI * 0.125, 1e-3);
  for (const MeshShape& mesh : {box, cylinder, sphere}) {
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_TRUE(isConvex(mesh));
  }
}

TEST(Tessellation, standsInTheParentFrame) {
  const Shape shape{CylinderShape{0.5, 2.0}, makePose(Vec3(1, 2, 3), Vec3(M_PI / 2.0, 0, 0))};
  const Bounds exact = boundsOf({shape});
  const Bounds mesh = boundsOf({{tessellate(shape), Pose::Identity()}});
  EXPECT_LT((mesh.min - exact.min).norm(), 1e-9);
  EXPECT_LT((mesh.max - exact.max).norm(), 1e-9);
}

}  // namespace
}  // namespace smore
