// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "smore/mapping/voxel_grid.h"

namespace octomap {
class OcTree;
}

namespace smore {

/// From this probability on a voxel counts as occupied (paper, section III-C).
constexpr double kOccupied = 0.5;

/// Octree with one leaf at the finest depth for each stored voxel and the same probabilities
/// (OctoMap stores log odds as float). The clamping thresholds are set so that no stored value is
/// altered, the inner nodes are up to date, and nothing is pruned.
std::unique_ptr<octomap::OcTree> toOctree(const VoxelGrid& grid);

/// The grid of an octree's leaves; pruned leaves are expanded.
VoxelGrid fromOctree(const octomap::OcTree& tree);

/// Writes a tree to a file of OctoMap's own format, whole or not at all: what was there before
/// stays where the disk is full. Throws std::runtime_error where it cannot be written.
void writeOctree(const octomap::OcTree& tree, const std::string& file);

}  // namespace smore
