// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "smore/mapping/voxel_grid.h"

namespace octomap {
class OcTree;
class OcTreeKey;
}  // namespace octomap

namespace smore {

/// From this probability on a voxel counts as occupied (paper, section III-C).
constexpr double kOccupied = 0.5;

/// Octree with one leaf at the finest depth for each stored voxel and the same probabilities
/// (OctoMap stores log odds as float). The clamping thresholds are set so that no stored value is
/// altered, the inner nodes are up to date, and nothing is pruned.
std::unique_ptr<octomap::OcTree> toOctree(const VoxelGrid& grid);

/// Octree of the voxels with P >= kOccupied only, for planning: a collision library that treats a
/// value of exactly 0.5 as free (FCL 0.7 does) still sees them.
std::unique_ptr<octomap::OcTree> toOccupiedOctree(const VoxelGrid& grid);

/// The voxel of a key at the finest depth of a tree of depth 16.
VoxelKey gridKey(const octomap::OcTreeKey& key);

/// The grid of an octree's leaves; pruned leaves are expanded.
VoxelGrid fromOctree(const octomap::OcTree& tree);

/// Writes a tree to a file of OctoMap's own format, whole or not at all: what was there before
/// stays where the disk is full. Throws std::runtime_error where it cannot be written.
void writeOctree(const octomap::OcTree& tree, const std::string& file);

}  // namespace smore
