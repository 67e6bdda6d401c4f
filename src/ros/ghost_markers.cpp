// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/ghost_markers.h"

#include <algorithm>

#include "smore/ros/conversions.h"
#include "smore/ros/marker_parts.h"

namespace smore {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kGhosts = 9;  // few enough to be told apart, a choice for the eye
constexpr float kOpacity = 0.35F;

}  // namespace

visualization_msgs::MarkerArray ghostMarkers(const Path& path, const std::vector<double>& risks,
                                             const OccupiedVoxels& object,
                                             const std::string& frame) {
  constexpr char kSpace[] = "ghost";
  visualization_msgs::MarkerArray array;
  array.markers.push_back(makeMarker(frame, kSpace, 0, Marker::CUBE_LIST));
  array.markers.back().action = Marker::DELETEALL;
  Marker ghost = makeMarker(frame, kSpace, 0, Marker::CUBE_LIST);
  ghost.scale = toScale(object.voxel_size, object.voxel_size, object.voxel_size);
  for (const Vec3& center : centersOf(object)) ghost.points.push_back(toPoint(center));
  if (ghost.points.empty()) return array;
  const std::size_t count = std::min(kGhosts, path.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count > 1 ? i * (path.size() - 1) / (count - 1) : 0;
    ghost.id = static_cast<int>(i);
    ghost.pose = toMessage(path[at]);
    ghost.color = riskColor(risks.at(at), kOpacity);
    array.markers.push_back(ghost);
  }
  return array;
}

}  // namespace smore
