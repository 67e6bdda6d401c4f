// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/prior_maps.h"

#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "smore/common/result.h"
#include "smore/mapping/map_frame.h"
#include "smore/mapping/octomap_export.h"
#include "smore/mapping/plane_in_grid.h"
#include "smore/scenario/mesh.h"
#include "smore/scenario/point_cloud.h"
#include "smore/scenario/solid_distance.h"

namespace smore {
namespace {

// Voxels of the maps over those of what is known, which is known better than touch tells.
constexpr double kFinerInPlane = 4.0;
constexpr double kFinerInSpace = 2.0;

// Where a box holds more voxels they are made larger: some hundred megabytes.
constexpr double kMostVoxels = 4e6;

/// Whether there is matter at a point of the map's frame, in front of any box and offset; nothing
/// where that is not known.
using Knowledge = std::function<std::optional<bool>(const Vec3& point)>;

struct Source {
  Knowledge knowledge;
  Bounds extent;  ///< beyond it nothing is known
};

Bounds widened(Bounds bounds, double margin) {
  bounds.min.array() -= margin;
  bounds.max.array() += margin;
  return bounds;
}

Bounds boundsOf(const std::vector<Vec3>& points) {
  Bounds bounds{points.front(), points.front()};
  for (const Vec3& point : points) {
    bounds.min = bounds.min.cwiseMin(point);
    bounds.max = bounds.max.cwiseMax(point);
  }
  return bounds;
}

Source ofSolids(const std::vector<Shape>& shapes, const Bounds& extent) {
  auto distance = std::make_shared<SolidDistance>(shapes);
  return {[distance](const Vec3& point) { return (*distance)(point) <= 0.0; }, extent};
}

// Only surfaces were seen: where no point is, nothing is known.
Source ofPoints(const std::vector<Vec3>& points, double voxel_size) {
  VoxelGrid grid(voxel_size);
  for (const Vec3& point : points) grid.set(voxelAt(point, voxel_size), 1.0F);
  const Knowledge knowledge = [grid](const Vec3& point) -> std::optional<bool> {
    if (!grid.probability(voxelAt(point, grid.voxelSize()))) return std::nullopt;
    return true;
  };
  return {knowledge, widened(boundsOf(points), 1.5 * voxel_size)};
}

// How many nodes the header of a file says that follow; a file that was cut has fewer.
std::size_t nodesInHeader(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string word;
  while (stream >> word && word != "data") {
    std::size_t count = 0;
    if (word == "size" && stream >> count) return count;
  }
  return 0;
}

using Octree = std::shared_ptr<const octomap::OcTree>;

// Asked voxel by voxel: pruned leaves may span a whole building.
Source ofOctree(const Octree& tree, const Pose& pose) {
  Bounds box;
  tree->getMetricMin(box.min.x(), box.min.y(), box.min.z());
  tree->getMetricMax(box.max.x(), box.max.y(), box.max.z());
  std::vector<Vec3> corners(kCorners);
  for (int i = 0; i < kCorners; ++i) corners[i] = pose * box.corner(i);
  const Pose T_tree_map = pose.inverse();
  const Knowledge knowledge = [tree, T_tree_map](const Vec3& point) -> std::optional<bool> {
    const Vec3 in_tree = T_tree_map * point;
    const octomap::OcTreeNode* node = tree->search(in_tree.x(), in_tree.y(), in_tree.z());
    if (node == nullptr) return std::nullopt;
    return node->getOccupancy() >= kOccupied;
  };
  return {knowledge, widened(boundsOf(corners), 0.5 * tree->getResolution())};
}

Octree readOctree(const std::string& file) {
  std::unique_ptr<octomap::AbstractOcTree> any;
  std::unique_ptr<octomap::OcTree> tree;
  if (file.substr(file.find_last_of('.')) == ".bt") {
    tree = std::make_unique<octomap::OcTree>(0.1);
    if (!tree->readBinary(file)) tree = nullptr;
  } else {
    any.reset(octomap::AbstractOcTree::read(file));
    if (dynamic_cast<octomap::OcTree*>(any.get()) != nullptr) {
      tree.reset(dynamic_cast<octomap::OcTree*>(any.release()));
    }
  }
  if (!tree || tree->size() == 0) {
    throw InputError(file + ": not an OctoMap of occupancies, or an empty one; write it with " +
                     "octomap_saver or octovis");
  }
  const std::size_t nodes = nodesInHeader(file);
  if (tree->size() < nodes) {
    throw InputError(file + ": ends after " + std::to_string(tree->size()) + " of " +
                     std::to_string(nodes) + " nodes; the file was cut");
  }
  return tree;
}

/// Makes the pieces of one map of a scene.
class PriorMaker {
 public:
  PriorMaker(const Scenario& scene, bool of_object)
      : scene_(scene),
        of_object_(of_object),
        planar_(scene.motion == Motion::kPlanar),
        plane_(of_object ? Pose::Identity() : scene.start.inverse()),
        voxel_size_(scene.voxel_size / (planar_ ? kFinerInPlane : kFinerInSpace)) {}

  Prior make(const PriorSource& entry) const {
    try {
      return makeInRange(entry);
    } catch (const std::out_of_range&) {
      throw InputError("scenario " + scene_.name + ": prior: " + nameOf(entry) +
                       " has points too far away for the voxels of the maps; check its scale (of "
                       "millimetres 0.001), position and offset");
    }
  }

 private:
  Prior makeInRange(const PriorSource& entry) const {
    const Source source = read(entry);
    Bounds box = source.extent;
    if (entry.box) {
      box.min = box.min.cwiseMax(entry.box->min);
      box.max = box.max.cwiseMin(entry.box->max);
    }
    Prior prior{voxelize(source.knowledge, box, entry.offset), entry.confidence};
    if (prior.known.empty()) {
      throw InputError("scenario " + scene_.name + ": prior: " + nameOf(entry) + " of the " +
                       (of_object_ ? "object" : "world") + " says nothing" +
                       (planar_ ? " in the plane of the motion" : "") +
                       "; check its min, max, position and offset");
    }
    return prior;
  }

  static std::string nameOf(const PriorSource& entry) {
    if (entry.format == PriorFormat::kTruth) return "truth";
    return entry.file.empty() ? "the cloud" : entry.file;
  }

  Source read(const PriorSource& entry) const {
    switch (entry.format) {
      case PriorFormat::kTruth:
        return truth();
      case PriorFormat::kOctree:
        return ofOctree(readOctree(entry.file), entry.pose);
      case PriorFormat::kCloud:
        return cloud(entry);
      case PriorFormat::kMesh:
        return mesh(entry);
    }
    throw InputError("unknown format of a prior");
  }

  Source truth() const {
    if (!scene_.hasScene()) {
      throw InputError("scenario " + scene_.name +
                       ": prior: the truth is known in simulation only; give a mesh, a cloud of "
                       "points or an OctoMap");
    }
    const double reach = reachOf(scene_.object) + voxel_size_;
    const Bounds around_object{Vec3::Constant(-reach), Vec3::Constant(reach)};
    return of_object_ ? ofSolids(scene_.object, around_object)
                      : ofSolids(scene_.environment, regionOfContacts(scene_));
  }

  // One voxel around the solid is known to be free, so that its surface is known for one.
  Source mesh(const PriorSource& entry) const {
    const std::vector<Shape> shapes = {{loadMesh(entry.file, entry.scale), entry.pose}};
    return ofSolids(shapes, widened(smore::boundsOf(shapes), 1.5 * voxel_size_));
  }

  Source cloud(const PriorSource& entry) const {
    std::vector<Vec3> points = entry.file.empty() ? entry.points : loadPointCloud(entry.file);
    for (Vec3& point : points) point = entry.pose * point;
    return ofPoints(points, voxel_size_);
  }

  double voxelSizeFor(const Bounds& box) const {
    const Vec3 counts = ((box.max - box.min) / voxel_size_).cwiseMax(1.0);
    const double count = planar_ ? plane_.mostPassed(counts) : counts.prod();
    return voxel_size_ * std::max(1.0, std::pow(count / kMostVoxels, planar_ ? 0.5 : 1.0 / 3.0));
  }

  VoxelGrid voxelize(const Knowledge& knowledge, const Bounds& box, const Vec3& offset) const {
    if ((box.min.array() > box.max.array()).any()) return VoxelGrid(voxel_size_);
    VoxelGrid grid(voxelSizeFor(box));
    const double size = grid.voxelSize();
    const auto ask = [&](const VoxelKey& key) {
      const Vec3 point = voxelCenter(key, size) - offset;
      if (!box.contains(point)) return;
      const std::optional<bool> matter = knowledge(point);
      if (matter) grid.set(key, *matter ? 1.0F : 0.0F);
    };
    const VoxelKey first = voxelAt(box.min + offset, size);
    const VoxelKey last = voxelAt(box.max + offset, size);
    planar_ ? plane_.visit(first, last, size, ask) : visitVoxels(first, last, ask);
    return grid;
  }

  const Scenario& scene_;
  bool of_object_;
  bool planar_;
  PlaneInGrid plane_;  ///< of planar motion
  double voxel_size_;
};

}  // namespace

Priors makePriors(const Scenario& scene) {
  Priors priors;
  for (const PriorSource& entry : scene.prior.object) {
    priors.object.push_back(makePrior(scene, MapSide::kObject, entry));
  }
  for (const PriorSource& entry : scene.prior.world) {
    priors.world.push_back(makePrior(scene, MapSide::kWorld, entry));
  }
  return priors;
}

Prior makePrior(const Scenario& scene, MapSide side, const PriorSource& source) {
  return PriorMaker(scene, side == MapSide::kObject).make(source);
}

}  // namespace smore
