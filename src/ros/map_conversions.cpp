// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/map_conversions.h"

#include <octomap/octomap.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "smore/mapping/octomap_export.h"
#include "smore/ros/marker_parts.h"

namespace smore {
namespace {

constexpr float kLeastOpacity = 0.15F;  // of markers; unlikely voxels must not hide the scene

octomap_msgs::Octomap emptyOctomap(const octomap::OcTree& tree, const std_msgs::Header& header,
                                   bool binary) {
  octomap_msgs::Octomap message;
  message.header = header;
  message.binary = static_cast<unsigned char>(binary);
  message.id = tree.getTreeType();
  message.resolution = tree.getResolution();
  return message;
}

void setData(const std::string& bytes, octomap_msgs::Octomap* message) {
  message->data.assign(bytes.begin(), bytes.end());
}

// Whether the data holds exactly one whole octree: readData alone accepts any prefix of one.
bool readWhole(const octomap_msgs::Octomap& message, octomap::OcTree* tree) {
  const std::string bytes(message.data.begin(), message.data.end());
  std::istringstream stream(bytes);
  tree->readData(stream);
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) return false;
  std::ostringstream again;
  tree->writeData(again);
  return again.str().size() == bytes.size();
}

std_msgs::ColorRGBA shade(const MapColors& colors, float probability) {
  const Vec3 mixed = colors.low + probability * (colors.high - colors.low);
  return makeColor(static_cast<float>(mixed.x()), static_cast<float>(mixed.y()),
                   static_cast<float>(mixed.z()), std::max(probability, kLeastOpacity));
}

}  // namespace

std_msgs::Header headerOf(const std::string& frame, const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frame;
  return header;
}

MapColors worldColors() { return {Vec3::Zero(), Vec3::Ones()}; }

MapColors objectColors() { return {Vec3(1.0, 0.94, 0.63), Vec3(0.48, 0.0, 0.06)}; }

octomap_msgs::Octomap fullOctomap(const VoxelGrid& grid, const std_msgs::Header& header) {
  const auto tree = toOctree(grid);
  octomap_msgs::Octomap message = emptyOctomap(*tree, header, false);
  std::ostringstream stream;
  tree->writeData(stream);
  setData(stream.str(), &message);
  return message;
}

octomap_msgs::OctomapWithPose posedOctomap(const VoxelGrid& grid, const std_msgs::Header& header) {
  octomap_msgs::OctomapWithPose message;
  message.header = header;
  message.origin.orientation.w = 1.0;
  message.octomap = fullOctomap(grid, header);
  return message;
}

octomap_msgs::Octomap binaryOctomap(const VoxelGrid& grid, const std_msgs::Header& header) {
  const auto tree = toOctree(grid);
  octomap_msgs::Octomap message = emptyOctomap(*tree, header, true);
  std::ostringstream stream;
  tree->writeBinaryData(stream);
  setData(stream.str(), &message);
  return message;
}

Result<VoxelGrid> fromMessage(const octomap_msgs::Octomap& message) {
  if (message.binary != 0 || message.id != "OcTree") {
    return Failure{"the map is not a full octree of type OcTree"};
  }
  if (!(message.resolution > 0.0)) return Failure{"the map's resolution is not positive"};
  octomap::OcTree tree(message.resolution);
  if (!message.data.empty() && !readWhole(message, &tree)) {
    return Failure{"the map's data is not an octree"};
  }
  return fromOctree(tree);
}

sensor_msgs::PointCloud2 occupiedCloud(const VoxelGrid& grid, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  const auto& voxels = grid.voxels();
  const auto occupied = [](const VoxelGrid::Voxel& voxel) {
    return voxel.probability >= kOccupied;
  };
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  constexpr int kFields = 4;
  constexpr auto kFloat = sensor_msgs::PointField::FLOAT32;
  modifier.setPointCloud2Fields(kFields, "x", 1, kFloat, "y", 1, kFloat, "z", 1, kFloat,
                                "intensity", 1, kFloat);
  modifier.resize(std::count_if(voxels.begin(), voxels.end(), occupied));
  sensor_msgs::PointCloud2Iterator<float> point(cloud, "x");
  for (const VoxelGrid::Voxel& voxel : voxels) {
    if (!occupied(voxel)) continue;
    const Vec3 center = voxelCenter(voxel.key, grid.voxelSize());
    for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<float>(center[axis]);
    point[3] = voxel.probability;
    ++point;
  }
  return cloud;
}

visualization_msgs::MarkerArray cellMarkers(const VoxelGrid& grid, const MapColors& colors,
                                            double min_probability,
                                            const std_msgs::Header& header) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.header.stamp = ros::Time();  // at the frame's newest pose, however old the map is
  marker.ns = header.frame_id + "_map";
  marker.type = visualization_msgs::Marker::CUBE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = static_cast<unsigned char>(true);
  marker.scale.x = marker.scale.y = marker.scale.z = grid.voxelSize();
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability < min_probability) continue;
    marker.points.push_back(toPoint(voxelCenter(voxel.key, grid.voxelSize())));
    marker.colors.push_back(shade(colors, voxel.probability));
  }
  marker.action =
      marker.points.empty() ? visualization_msgs::Marker::DELETE : visualization_msgs::Marker::ADD;
  visualization_msgs::MarkerArray array;
  array.markers.push_back(marker);
  return array;
}

}  // namespace smore
