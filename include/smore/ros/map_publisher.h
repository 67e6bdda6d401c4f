// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <optional>
#include <string>

#include "smore/ros/map_conversions.h"
#include "smore/ros/names.h"
#include "smore/ros/revised_topic.h"

namespace smore {

/// Everything published of one of the two maps. Each topic sends a revision once, when somebody
/// listens; what comes later finds the last one latched.
class MapPublisher {
 public:
  MapPublisher(const ros::NodeHandle& node, const std::string& space, const std::string& frame,
               const MapColors& colors, double min_probability)
      : frame_(frame), colors_(colors), min_probability_(min_probability) {
    ros::NodeHandle map_node(node, space);
    map_node.setCallbackQueue(node.getCallbackQueue());
    full_.open<octomap_msgs::Octomap>(&map_node, names::kOctomapFull);
    binary_.open<octomap_msgs::Octomap>(&map_node, names::kOctomapBinary);
    posed_.open<octomap_msgs::OctomapWithPose>(&map_node, names::kOctomapWithPose);
    cloud_.open<sensor_msgs::PointCloud2>(&map_node, names::kPointCloud);
    cells_.open<visualization_msgs::MarkerArray>(&map_node, names::kOccupiedCells);
  }

  bool isDue(std::uint64_t revision) const {
    return full_.isDue(revision) || binary_.isDue(revision) || posed_.isDue(revision) ||
           cloud_.isDue(revision) || cells_.isDue(revision);
  }

  /// Shows voxels from this probability on, in (0, 1]; the markers come anew where it is another.
  void showFrom(double min_probability) {
    if (min_probability == min_probability_) return;
    min_probability_ = min_probability;
    cells_.renew();
  }

  /// Voxels of the last map that was published; nothing before.
  const std::optional<std::size_t>& voxels() const { return voxels_; }

  void publish(const VoxelGrid& grid, std::uint64_t revision, const ros::Time& stamp) {
    voxels_ = grid.size();
    const std_msgs::Header header = headerAt(stamp);
    full_.send(revision, [&] { return fullOctomap(grid, header); });
    binary_.send(revision, [&] { return binaryOctomap(grid, header); });
    posed_.send(revision, [&] { return posedOctomap(grid, header); });
    cloud_.send(revision, [&] { return occupiedCloud(grid, header); });
    cells_.send(revision, [&] { return cellMarkers(grid, colors_, min_probability_, header); });
  }

  std_msgs::Header headerAt(const ros::Time& stamp) const { return headerOf(frame_, stamp); }

 private:
  std::string frame_;
  MapColors colors_;
  double min_probability_;
  std::optional<std::size_t> voxels_;
  RevisedTopic full_, binary_, posed_, cloud_, cells_;
};

}  // namespace smore
