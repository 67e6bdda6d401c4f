// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <octomap_msgs/GetOctomap.h>

#include <limits>
#include <random>

#include "smore/ros/map_conversions.h"
#include "smore/ros/scene_markers.h"

namespace smore {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

VoxelGrid sampleGrid() {
  VoxelGrid grid(0.03);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> key(-40, 40);
  std::uniform_real_distribution<float> probability(0.005F, 0.995F);
  for (int i = 0; i < 500; ++i) {
    grid.set({static_cast<std::int16_t>(key(random)), static_cast<std::int16_t>(key(random)),
              static_cast<std::int16_t>(key(random))},
             probability(random));
  }
  grid.set({100, -100, 5}, 0.5F);
  return grid;
}

std_msgs::Header headerOf(const std::string& frame) {
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp.fromSec(4.5);
  return header;
}

TEST(MapConversions, FullOctomapsKeepEveryVoxelAndItsProbability) {
  const VoxelGrid grid = sampleGrid();
  const octomap_msgs::Octomap message = fullOctomap(grid, headerOf("world"));
  EXPECT_EQ(message.id, "OcTree");
  EXPECT_EQ(message.binary, 0);
  EXPECT_EQ(message.header.frame_id, "world");
  const Result<VoxelGrid> back = fromMessage(message);
  ASSERT_TRUE(back) << back.reason();
  ASSERT_EQ(back->size(), grid.size());
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    ASSERT_TRUE(back->probability(voxel.key));
    EXPECT_NEAR(*back->probability(voxel.key), voxel.probability, 1e-6);
  }
}

TEST(MapConversions, PosedOctomapsAreFullOnesAtTheOriginOfTheirFrame) {
  const octomap_msgs::OctomapWithPose message = posedOctomap(sampleGrid(), headerOf("object"));
  EXPECT_EQ(message.header.frame_id, "object");
  EXPECT_EQ(message.header.stamp.toSec(), 4.5);
  EXPECT_EQ(message.origin.position.x, 0.0);
  EXPECT_EQ(message.origin.orientation.w, 1.0);
  EXPECT_EQ(message.octomap.data, fullOctomap(sampleGrid(), headerOf("object")).data);
}

TEST(MapConversions, EmptyMapsComeBackEmpty) {
  const Result<VoxelGrid> back = fromMessage(fullOctomap(VoxelGrid(0.05), headerOf("object")));
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->empty());
  EXPECT_DOUBLE_EQ(back->voxelSize(), 0.05);
}

TEST(MapConversions, BrokenOctomapsAreRefused) {
  const octomap_msgs::Octomap good = fullOctomap(sampleGrid(), headerOf("world"));
  octomap_msgs::Octomap bad = good;
  bad.binary = 1;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.id = "ColorOcTree";
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.resolution = kNan;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.data.resize(bad.data.size() / 2);
  EXPECT_FALSE(fromMessage(bad));
}

TEST(MapConversions, TypesAndChecksumsAreThoseOfOctomapMsgs) {
  EXPECT_STREQ(ros::message_traits::datatype<octomap_msgs::Octomap>(), "octomap_msgs/Octomap");
  EXPECT_STREQ(ros::message_traits::md5sum<octomap_msgs::Octomap>(),
               "9a45536b45c5e409cd49f04bb2d9999f");
  EXPECT_STREQ(ros::service_traits::datatype<octomap_msgs::GetOctomap>(),
               "octomap_msgs/GetOctomap");
  EXPECT_STREQ(ros::message_traits::md5sum<octomap_msgs::OctomapWithPose>(),
               "20b380aca6a508a657e95526cddaf618");
  EXPECT_STREQ(ros::service_traits::md5sum<octomap_msgs::GetOctomap>(),
               "be9d2869d24fe40d6bc21ac21f6bb2c5");
}

TEST(MapConversions, CloudsHoldTheOccupiedVoxelsAtExactlyAHalfToo) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.49F);
  grid.set({1, 2, 3}, 0.5F);
  grid.set({-1, 0, 0}, 0.9F);
  const sensor_msgs::PointCloud2 cloud = occupiedCloud(grid, headerOf("world"));
  EXPECT_EQ(cloud.width * cloud.height, 2U);
  const auto* values = reinterpret_cast<const float*>(cloud.data.data());
  EXPECT_FLOAT_EQ(values[0], 0.15F);
  EXPECT_FLOAT_EQ(values[1], 0.25F);
  EXPECT_FLOAT_EQ(values[2], 0.35F);
}

TEST(MapConversions, CellMarkersShadeByProbability) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.1F);
  grid.set({1, 0, 0}, 1.0F);
  grid.set({2, 0, 0}, 0.5F);
  const auto array = cellMarkers(grid, {Vec3::UnitY(), Vec3::UnitX()}, 0.3, headerOf("object"));
  ASSERT_EQ(array.markers.size(), 1U);
  const auto& marker = array.markers[0];
  ASSERT_EQ(marker.points.size(), 2U);
  EXPECT_FLOAT_EQ(marker.colors[0].r, 1.0F);
  EXPECT_FLOAT_EQ(marker.colors[0].g, 0.0F);
  EXPECT_FLOAT_EQ(marker.colors[1].r, 0.5F);
  EXPECT_FLOAT_EQ(marker.colors[1].g, 0.5F);
}

TEST(SceneMarkers, HaveOneMarkerForEachShapeInItsFrame) {
  Scenario scenario;
  scenario.object = {{BoxShape{{0.1, 0.2, 0.3}}, makePose({1, 0, 0})}};
  scenario.environment = {{CylinderShape{0.05, 0.4}, Pose::Identity()},
                          {SphereShape{0.1}, Pose::Identity()}};
  const auto array = sceneMarkers(scenario, {"world", "object"});
  ASSERT_EQ(array.markers.size(), 3U);
  EXPECT_EQ(array.markers[0].header.frame_id, "world");
  EXPECT_DOUBLE_EQ(array.markers[0].scale.x, 0.1);
  EXPECT_DOUBLE_EQ(array.markers[0].scale.z, 0.4);
  EXPECT_EQ(array.markers[2].header.frame_id, "object");
  EXPECT_DOUBLE_EQ(array.markers[2].pose.position.x, 1.0);
}

}  // namespace
}  // namespace smore
