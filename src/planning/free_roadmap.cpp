// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/free_roadmap.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

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

// Edges along each track, and between poses that are the same. `track_of` tells the track of each
// pose.
Edges edgesBetween(const Path& poses, const std::vector<int>& track_of,
                   const FreeSpaceParameters& cell) {
  const int count = static_cast<int>(poses.size());
  Edges edges(count);
  for (int i = 1; i < count; ++i) {
    const bool is_next = track_of[i] == track_of[i - 1];
    if (is_next) join(poses, i - 1, i, &edges);
    const int others = is_next ? i - 1 : i;
    for (int k = 0; k < others; ++k) {
      if (same(poses[i], poses[k], cell)) join(poses, k, i, &edges);
    }
  }
  return edges;
}

}  // namespace

FreeRoadmap::FreeRoadmap(const std::vector<Path>& tracks, const Pose& from,
                         const FreeSpaceParameters& cell) {
  Path poses{from};
  std::vector<int> track_of{-1};
  for (std::size_t track = 0; track < tracks.size(); ++track) {
    poses.insert(poses.end(), tracks[track].begin(), tracks[track].end());
    track_of.insert(track_of.end(), tracks[track].size(), static_cast<int>(track));
  }
  const int count = static_cast<int>(poses.size());
  const Edges edges = edgesBetween(poses, track_of, cell);

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
