// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/free_roadmap.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "smore/mapping/free_tracks.h"

namespace smore {
namespace {

struct Edge {
  int to = 0;
  double length = 0.0;
};

using Edges = std::vector<std::vector<Edge>>;

bool same(const Pose& a, const Pose& b, const FreeSpaceParameters& cell) {
  return distanceBetween(a, b) <= cell.position_cell && angleBetween(a, b) <= cell.angle_cell;
}

void join(const Path& poses, int a, int b, Edges* edges) {
  const double length = gapBetween(poses[a], poses[b]);
  (*edges)[a].push_back({b, length});
  (*edges)[b].push_back({a, length});
}

// Whether the motion from `a` to `b` passes `pose`; where it hardly moves, in its turn.
bool passes(const Pose& a, const Pose& b, const Pose& pose, const FreeSpaceParameters& cell) {
  const Vec3 along = b.translation() - a.translation();
  const Vec3 to_pose = pose.translation() - a.translation();
  if (to_pose.norm() > along.norm() + cell.position_cell) return false;
  const double turn = angleBetween(a, b);
  double share = 0.0;
  if (along.norm() > cell.position_cell) {
    share = along.dot(to_pose) / along.squaredNorm();
  } else if (turn > 0.0) {
    share = angleBetween(a, pose) / turn;
  }
  return same(interpolate(a, b, std::clamp(share, 0.0, 1.0)), pose, cell);
}

// Edges along each track, from each pose to those that are the same, and to both ends of motions
// that pass it. `track_of` tells the track of each pose.
Edges edgesBetween(const Path& poses, const std::vector<int>& track_of,
                   const FreeSpaceParameters& cell) {
  const int count = static_cast<int>(poses.size());
  Edges edges(count);
  const auto is_motion_to = [&](int i) { return i > 0 && track_of[i] == track_of[i - 1]; };
  for (int i = 0; i < count; ++i) {
    if (is_motion_to(i)) join(poses, i - 1, i, &edges);
    const int others = is_motion_to(i) ? i - 1 : i;
    for (int k = 0; k < others; ++k) {
      if (same(poses[i], poses[k], cell)) join(poses, k, i, &edges);
    }
    for (int k = 1; k < count; ++k) {
      const bool is_own = k == i || k - 1 == i;
      if (is_own || !is_motion_to(k) || !passes(poses[k - 1], poses[k], poses[i], cell)) continue;
      join(poses, k - 1, i, &edges);
      join(poses, k, i, &edges);
    }
  }
  return edges;
}

}  // namespace

std::vector<Path> tracksWithin(const MotionSpace& space, const std::vector<Path>& tracks) {
  std::vector<Path> within;
  for (const Path& track : tracks) {
    bool goes_on = false;
    for (const Pose& pose : track) {
      const bool is_within = space.isNearWorkspace(pose);
      if (is_within && !goes_on) within.emplace_back();
      if (is_within) within.back().push_back(pose);
      goes_on = is_within;
    }
  }
  return within;
}

FreeRoadmap::FreeRoadmap(const std::vector<Path>& tracks, const Pose& from,
                         const FreeSpaceParameters& cell, double unit) {
  Path poses{from};
  std::vector<int> track_of{-1};
  for (std::size_t track = 0; track < tracks.size(); ++track) {
    poses.insert(poses.end(), tracks[track].begin(), tracks[track].end());
    track_of.insert(track_of.end(), tracks[track].size(), static_cast<int>(track));
  }
  const int count = static_cast<int>(poses.size());
  Edges edges = edgesBetween(poses, track_of, cell);
  for (int i = 1; i < count; ++i) {
    if (isThinnedOut(poses[i], from, unit)) join(poses, 0, i, &edges);
  }

  // Dijkstra's algorithm; poses become reachable in the order of their distance.
  std::vector<double> distance(count, std::numeric_limits<double>::infinity());
  std::vector<int> before(count, -1);
  std::vector<int> place(count, -1);
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  distance[0] = 0.0;
  open.push({0.0, 0});
  while (!open.empty()) {
    const int here = open.top().second;
    open.pop();
    if (place[here] >= 0) continue;
    place[here] = static_cast<int>(reachable_.size());
    reachable_.push_back(poses[here]);
    previous_.push_back(before[here] < 0 ? -1 : place[before[here]]);
    for (const Edge& edge : edges[here]) {
      const double length = distance[here] + edge.length;
      if (length >= distance[edge.to]) continue;
      distance[edge.to] = length;
      before[edge.to] = here;
      open.push({length, edge.to});
    }
  }
}

Path FreeRoadmap::routeTo(int reachable) const {
  Path route;
  for (int i = reachable; i >= 0; i = previous_[i]) route.push_back(reachable_[i]);
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace smore
