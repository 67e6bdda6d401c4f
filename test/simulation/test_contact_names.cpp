// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "contact_trials.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

// A mesh of several parts counts as one shape; a box that comes after it has an index of its own.
TEST(ContactNames, ofPartsOfAMeshAreTheObjects) {
  MeshShape mesh;
  for (const double side : {-0.3, 0.3}) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                      (corner & 4) != 0 ? 1 : -1);
      mesh.vertices.push_back(Vec3(0, side, 0) + 0.05 * sign);
    }
    ConvexPart part;
    part.vertices.assign(mesh.vertices.end() - 8, mesh.vertices.end());
    mesh.parts.push_back(part);
  }
  for (const int first : {0, 8}) {
    for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      mesh.triangles.emplace_back(first + a, first + b, first + c);
      mesh.triangles.emplace_back(first + a, first + c, first + d);
    }
  }
  const Shape box{BoxShape{Vec3(0.1, 0.1, 0.1)}, makePose(Vec3(0, 0.8, 0))};
  const std::vector<Shape> wall = {{BoxShape{Vec3(0.2, 4.0, 1.0)}, Pose::Identity()}};
  const auto robot = makeSimulatedRobot(sceneOf({{mesh, Pose::Identity()}, box}, wall), 1);
  robot->follow({Pose::Identity()});
  while (robot->moving() && robot->advance().wrench.force.norm() < 5.0) {
  }
  ASSERT_FALSE(robot->contacts().empty());
  for (const ContactPoint& point : robot->contacts()) EXPECT_EQ(point.body, kObjectBody);
}

}  // namespace
}  // namespace smore
