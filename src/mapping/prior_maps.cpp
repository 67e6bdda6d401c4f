// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/prior_maps.h"

#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "smore/common/result.h"
#include "smore/mapping/map_frame.h"
#include "smore/mapping/octomap_export.h"
#include "smore/mapping/octree_file.h"
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

/// Whether there is matter in the voxel of this size around a point of the map's frame, in front of
/// any box and offset; nothing where that is not known.
using Knowledge = std::function<std::optional<bool>(const Vec3& point, double voxel_size)>;

/// A point in matter that is so wide: centres of voxels that are wider than half of it may miss it.
struct MatterPoint {
  Vec3 point;
  double width = 0.0;  ///< [m]
};

struct Source {
  Knowledge knowledge;  ///< null: nothing is known but where there is matter
  Bounds extent;        ///< beyond it nothing is known
  std::vector<MatterPoint> matter = {};
};

Bounds boundsOf(const std::vector<Vec3>& points) {
  Bounds bounds{points.front(), points.front()};
  for (const Vec3& point : points) {
    bounds.min = bounds.min.cwiseMin(point);
    bounds.max = bounds.max.cwiseMax(point);
  }
  return bounds;
}

// Whether what lies within half a voxel of a centre is too thin to hold any centre behind that one,
// along the axis or the diagonal that leads into it: a sheet between two layers of voxels.
bool isMissed(const SolidDistance& distance, const Vec3& center, double size) {
  constexpr double kStep = 0.1;       // of the gradient, in voxels
  constexpr double kSlanted = 0.15;   // components below count as 0
  constexpr double kRounding = 0.15;  // of a centre beside a solid's edge, in voxels
  Vec3 outward;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = kStep * size * Vec3::Unit(i);
    outward[i] = distance(center + step) - distance(center - step);
  }
  outward.normalize();
  int steepest = 0;
  outward.cwiseAbs().maxCoeff(&steepest);
  Vec3 along = Vec3::Zero();
  Vec3 across = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double inward = outward[i] > 0.0 ? -size : size;
    if (i == steepest) along[i] = inward;
    if (std::abs(outward[i]) > kSlanted) across[i] = inward;
  }
  return distance(center + along) > kRounding * size &&
         distance(center + across) > kRounding * size;
}

Source ofSolids(const std::vector<Shape>& shapes, const Bounds& extent) {
  auto distance = std::make_shared<SolidDistance>(shapes);
  return {[distance](const Vec3& point, double size) {
            const double outside = (*distance)(point);
            return outside <= 0.0 || (outside <= 0.5 * size && isMissed(*distance, point, size));
          },
          extent};
}

using Octree = std::shared_ptr<const octomap::OcTree>;

// Asked voxel by voxel, as pruned leaves may span a whole building, and leaf by leaf where these
// are so small that the centre of a voxel tells nothing of them.
Source ofOctree(const Octree& tree, const Pose& pose) {
  Bounds box;
  tree->getMetricMin(box.min.x(), box.min.y(), box.min.z());
  tree->getMetricMax(box.max.x(), box.max.y(), box.max.z());
  std::vector<Vec3> corners(kCorners);
  for (int i = 0; i < kCorners; ++i) corners[i] = pose * box.corner(i);
  const Pose T_tree_map = pose.inverse();
  const Knowledge knowledge = [tree, T_tree_map](const Vec3& point, double) -> std::optional<bool> {
    const Vec3 in_tree = T_tree_map * point;
    const octomap::OcTreeNode* node = tree->search(in_tree.x(), in_tree.y(), in_tree.z());
    if (node == nullptr) return std::nullopt;
    return node->getOccupancy() >= kOccupied;
  };
  Source source{knowledge, boundsOf(corners).widened(0.5 * tree->getResolution())};
  for (auto leaf = tree->begin_leafs(); leaf != tree->end_leafs(); ++leaf) {
    if (leaf->getOccupancy() < kOccupied) continue;
    source.matter.push_back({pose * Vec3(leaf.getX(), leaf.getY(), leaf.getZ()), leaf.getSize()});
  }
  return source;
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
                       "millimetres 0.001), position and offset, or bound it by min and max");
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
    Prior prior{voxelize(source, box, entry.offset), entry.confidence};
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

  // One voxel around the solid is known to be free, so that its surface is known for one. Voxels
  // may grow with the box, and the box then grows with them.
  Bounds withFreeRim(const Bounds& solid) const {
    Bounds box = solid;
    for (double size = voxel_size_, last = 0.0; size > last; size = voxelSizeFor(box)) {
      box = solid.widened(1.5 * size);
      last = size;
    }
    return box;
  }

  Source mesh(const PriorSource& entry) const {
    const double largest = of_object_ ? kLargestHeld : kLargestScene;
    const std::vector<Shape> shapes = {{loadMesh(entry.file, entry.scale, largest), entry.pose}};
    return ofSolids(shapes, withFreeRim(smore::boundsOf(shapes)));
  }

  Source cloud(const PriorSource& entry) const {
    std::vector<Vec3> points = entry.file.empty() ? entry.points : loadPointCloud(entry.file);
    for (Vec3& point : points) point = entry.pose * entry.scale.cwiseProduct(point);
    const Bounds extent = boundsOf(points);
    const double size = (extent.max - extent.min).maxCoeff();
    if (of_object_ && size > kLargestHeld) {
      throw InputError("scenario " + scene_.name + ": prior: " + nameOf(entry) + " is " +
                       std::to_string(size) + " m large, which no gripper holds; check its scale " +
                       "(of millimetres 0.001)");
    }
    Source source{nullptr, extent};
    source.matter.reserve(points.size());
    for (const Vec3& point : points) source.matter.push_back({point});
    return source;
  }

  double voxelSizeFor(const Bounds& box) const {
    const Vec3 counts = ((box.max - box.min) / voxel_size_).cwiseMax(1.0);
    const double count = planar_ ? plane_.mostPassed(counts) : counts.prod();
    return voxel_size_ * std::max(1.0, std::pow(count / kMostVoxels, planar_ ? 0.5 : 1.0 / 3.0));
  }

  VoxelGrid voxelize(const Source& source, const Bounds& box, const Vec3& offset) const {
    if ((box.min.array() > box.max.array()).any()) return VoxelGrid(voxel_size_);
    VoxelGrid grid(source.knowledge ? voxelSizeFor(box) : voxel_size_);
    if (source.knowledge) ask(source.knowledge, box, offset, &grid);
    for (const MatterPoint& matter : source.matter) {
      if (matter.width >= 2.0 * grid.voxelSize() || !box.contains(matter.point)) continue;
      setMatter(matter.point + offset, &grid);
    }
    return grid;
  }

  void ask(const Knowledge& knowledge, const Bounds& box, const Vec3& offset,
           VoxelGrid* grid) const {
    const double size = grid->voxelSize();
    const auto set = [&](const VoxelKey& key) {
      const Vec3 point = voxelCenter(key, size) - offset;
      if (!box.contains(point)) return;
      const std::optional<bool> matter = knowledge(point, size);
      if (matter) grid->set(key, *matter ? 1.0F : 0.0F);
    };
    const VoxelKey first = voxelAt(box.min + offset, size);
    const VoxelKey last = voxelAt(box.max + offset, size);
    planar_ ? plane_.visit(first, last, size, set) : visitVoxels(first, last, set);
  }

  void setMatter(const Vec3& point, VoxelGrid* grid) const {
    const VoxelKey key = voxelAt(point, grid->voxelSize());
    const Vec3 center = voxelCenter(key, grid->voxelSize());
    if (!planar_ || plane_.passes(center, grid->voxelSize())) grid->set(key, 1.0F);
  }

  const Scenario& scene_;
  bool of_object_;
  bool planar_;
  PlaneInGrid plane_;  ///< of planar motion
  double voxel_size_;
};

}  // namespace

Priors makePriors(const Scenario& scene) {
  std::string problems;
  const auto made = [&](MapSide side, const std::vector<PriorSource>& sources) {
    std::vector<Prior> priors;
    for (const PriorSource& source : sources) {
      try {
        priors.push_back(makePrior(scene, side, source));
      } catch (const InputError& error) {
        problems += (problems.empty() ? "" : "\n") + std::string(error.what());
      }
    }
    return priors;
  };
  Priors priors;
  priors.object = made(MapSide::kObject, scene.prior.object);
  priors.world = made(MapSide::kWorld, scene.prior.world);
  if (!problems.empty()) throw InputError(problems);
  return priors;
}

Prior makePrior(const Scenario& scene, MapSide side, const PriorSource& source) {
  return PriorMaker(scene, side == MapSide::kObject).make(source);
}

}  // namespace smore
