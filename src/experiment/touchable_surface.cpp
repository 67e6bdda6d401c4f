// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/touchable_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "smore/mapping/octomap_export.h"
#include "smore/scenario/solid_distance.h"

namespace smore {
namespace {

constexpr double kSpacing = 0.01;        // of the points [m]
constexpr double kPositionStep = 0.02;   // of the lattice of poses [m]
constexpr int kTurns = 63;               // steps of a full turn: 0.1 rad
constexpr double kTouchDistance = 0.02;  // what is nearer at a free pose can be touched [m]

/// Position and turn in the plane of motion, in steps.
using Cell = std::array<int, 3>;

// Moves a point within the plane onto the surface, by Newton's method along the distance's slope.
Vec3 ontoSurface(const SolidDistance& solids, const Pose& T_shapes_plane, Vec3 in_plane) {
  constexpr double kSlopeStep = 1e-4;  // [m]
  constexpr int kIterations = 4;
  const auto distance = [&](const Vec3& point) { return solids(T_shapes_plane * point); };
  for (int i = 0; i < kIterations; ++i) {
    Vec3 slope = Vec3::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      const Vec3 step = kSlopeStep * Vec3::Unit(axis);
      slope[axis] = (distance(in_plane + step) - distance(in_plane - step)) / (2.0 * kSlopeStep);
    }
    if (slope.squaredNorm() < 0.25) break;  // a ridge: no nearest point to go to
    in_plane -= distance(in_plane) * slope / slope.squaredNorm();
  }
  return in_plane;
}

// Points of the shapes' outline in the x-y plane of `T_shapes_plane`, within `region`.
std::vector<Vec3> outline(const SolidDistance& solids, const Bounds& region,
                          const Pose& T_shapes_plane) {
  const double reach = (region.max - region.min).norm();
  const Vec3 middle = T_shapes_plane.inverse() * Vec3(0.5 * (region.min + region.max));
  const int half = static_cast<int>(std::ceil(0.5 * reach / kSpacing)) + 1;
  std::set<std::array<long, 2>> taken;
  std::vector<Vec3> points;
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      const Vec3 cell(middle.x() + x * kSpacing, middle.y() + y * kSpacing, 0.0);
      if (std::abs(solids(T_shapes_plane * cell)) > kSpacing) continue;
      const Vec3 point = ontoSurface(solids, T_shapes_plane, cell);
      const Vec3 in_shapes = T_shapes_plane * point;
      if (std::abs(solids(in_shapes)) > 0.1 * kSpacing) continue;
      if (taken.insert({std::lround(point.x() / kSpacing), std::lround(point.y() / kSpacing)})
              .second) {
        points.push_back(in_shapes);
      }
    }
  }
  return points;
}

// The part of the environment that the object may touch.
Bounds touchedRegion(const Scenario& scenario) {
  const Bounds solids = boundsOf(scenario.environment);
  const Bounds region = regionOfContacts(scenario);
  const auto into = [&](const Vec3& point) -> Vec3 {
    return point.cwiseMax(region.min).cwiseMin(region.max);
  };
  return {into(solids.min), into(solids.max)};
}

/// Visits all poses that can be reached and notes what comes near the other body.
class Flood {
 public:
  explicit Flood(const Scenario& scenario)
      : scenario_(scenario),
        object_solids_(scenario.object),
        world_solids_(scenario.environment),
        object_(outline(object_solids_, boundsOf(scenario.object), Pose::Identity())),
        world_(outline(world_solids_, touchedRegion(scenario), scenario.start)),
        object_touched_(object_.size(), false),
        world_touched_(world_.size(), false) {}

  TouchableSurface run() {
    std::vector<Cell> open;
    std::set<Cell> seen;
    const auto visit = [&](const Cell& cell) {
      if (seen.insert(cell).second && enter(poseOf(cell))) open.push_back(cell);
    };
    visit({0, 0, 0});
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          Cell next = cell;
          next[axis] += step;
          next[2] = (next[2] + kTurns) % kTurns;
          visit(next);
        }
      }
    }
    return {marked(object_, object_touched_), marked(world_, world_touched_)};
  }

 private:
  Pose poseOf(const Cell& cell) const {
    const Vec3 position(cell[0] * kPositionStep, cell[1] * kPositionStep, 0.0);
    return scenario_.start * makePose(position, Vec3(0, 0, cell[2] * 2.0 * M_PI / kTurns));
  }

  // Notes the points that are near the other body at a free pose; false where it is not free.
  bool enter(const Pose& T_world_object) {
    if (!scenario_.motionSpace().contains(T_world_object)) return false;
    near_world_.clear();
    near_object_.clear();
    if (!freeOf(world_, object_solids_, T_world_object.inverse(), &near_world_)) return false;
    if (!freeOf(object_, world_solids_, T_world_object, &near_object_)) return false;
    for (const int i : near_object_) object_touched_[i] = true;
    for (const int i : near_world_) world_touched_[i] = true;
    return true;
  }

  static bool freeOf(const std::vector<Vec3>& points, const SolidDistance& other,
                     const Pose& T_other_points, std::vector<int>* near) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = other(T_other_points * points[i]);
      if (distance <= 0.0) return false;
      if (distance <= kTouchDistance) near->push_back(static_cast<int>(i));
    }
    return true;
  }

  static std::vector<Vec3> marked(const std::vector<Vec3>& points, const std::vector<bool>& marks) {
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (marks[i]) result.push_back(points[i]);
    }
    return result;
  }

  const Scenario& scenario_;
  SolidDistance object_solids_;
  SolidDistance world_solids_;
  std::vector<Vec3> object_;
  std::vector<Vec3> world_;
  std::vector<bool> object_touched_;
  std::vector<bool> world_touched_;
  std::vector<int> near_object_;
  std::vector<int> near_world_;
};

}  // namespace

TouchableSurface touchableSurface(const Scenario& scenario) {
  if (scenario.motion != Motion::kPlanar) return {};
  return Flood(scenario).run();
}

std::optional<double> surfaceRecall(const VoxelGrid& grid, const std::vector<Vec3>& points) {
  if (points.empty()) return std::nullopt;
  std::vector<Vec3> centers;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability >= kOccupied) {
      centers.push_back(voxelCenter(voxel.key, grid.voxelSize()));
    }
  }
  const auto known = [&](const Vec3& point) {
    return std::any_of(centers.begin(), centers.end(), [&](const Vec3& center) {
      return (center - point).norm() <= grid.voxelSize();
    });
  };
  return static_cast<double>(std::count_if(points.begin(), points.end(), known)) /
         static_cast<double>(points.size());
}

}  // namespace smore
