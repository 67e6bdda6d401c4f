// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap_msgs/Octomap.h>
#include <octomap_msgs/OctomapWithPose.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "smore/common/geometry.h"
#include "smore/common/result.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// Of a map in this frame, as it was at `stamp`.
std_msgs::Header headerOf(const std::string& frame, const ros::Time& stamp);

/// The grid as an octree with its probabilities, as octomap clients read it.
octomap_msgs::Octomap fullOctomap(const VoxelGrid& grid, const std_msgs::Header& header);

/// The full octree at the origin of its frame, as planning scenes take it.
octomap_msgs::OctomapWithPose posedOctomap(const VoxelGrid& grid, const std_msgs::Header& header);

/// The grid as an octree of occupied (P >= 0.5) and free voxels only.
octomap_msgs::Octomap binaryOctomap(const VoxelGrid& grid, const std_msgs::Header& header);

/// The grid of a full octree; a failure for binary ones, other types than OcTree, and broken data.
Result<VoxelGrid> fromMessage(const octomap_msgs::Octomap& message);

/// Centres of the occupied voxels (P >= 0.5) with fields x, y, z [m] and intensity: the
/// probability.
sensor_msgs::PointCloud2 occupiedCloud(const VoxelGrid& grid, const std_msgs::Header& header);

/// Colours of a map: those of probability 0 and of 1; between them it is linear. RGB in [0, 1].
struct MapColors {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Ones();
};

/// Black to white, as in the paper's figures.
MapColors worldColors();

/// Pale yellow to dark red. The paper has green to red, which not everybody can tell apart.
MapColors objectColors();

/// The voxels with at least `min_probability` in (0, 1] as one list of cubes, the likely ones more
/// opaque.
visualization_msgs::MarkerArray cellMarkers(const VoxelGrid& grid, const MapColors& colors,
                                            double min_probability, const std_msgs::Header& header);

}  // namespace smore
