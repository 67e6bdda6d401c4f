// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/belief_markers.h"

#include <array>
#include <map>
#include <string>
#include <vector>

#include "smore/ros/marker_parts.h"

namespace smore {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLetterHeight = 0.5;  // in units of length

HypothesisMask onlyWorld(int index) { return HypothesisMask{1} << index; }

/// The places of one contact, each with the worlds that hold it to be there.
std::map<std::array<double, 3>, HypothesisMask> placesOf(
    const std::vector<std::optional<Vec3>>& in_worlds) {
  std::map<std::array<double, 3>, HypothesisMask> places;
  for (int i = 0; i < static_cast<int>(in_worlds.size()); ++i) {
    if (!in_worlds[i]) continue;
    const Vec3& place = *in_worlds[i];
    places[{place.x(), place.y(), place.z()}] |= onlyWorld(i);
  }
  return places;
}

/// Draws the balls of the worlds of one unit of length.
class WorldDrawing {
 public:
  WorldDrawing(const WorldsAtUnit& part, HypothesisMask world, MarkerArray* array)
      : part_(part), world_(world), array_(array) {}

  /// `pose`: of the points' frame in `frame`.
  void draw(const std::string& name, int id, const std::vector<MaskedPoint>& points, double radius,
            const std_msgs::ColorRGBA& color, const std::string& frame, const Pose& pose) {
    Marker balls = makeMarker(frame, name, id, Marker::SPHERE_LIST);
    balls.pose = toMessage(pose);
    balls.frame_locked = static_cast<unsigned char>(true);
    balls.scale = toScale(2.0 * radius, 2.0 * radius, 2.0 * radius);
    balls.color = color;
    for (const MaskedPoint& ball : points) {
      if ((ball.mask & world_) != 0) balls.points.push_back(toPoint(ball.point.cast<double>()));
    }
    if (!balls.points.empty()) array_->markers.push_back(balls);
  }

  void drawAll(const FrameNames& frames, const Pose& T_world_map) {
    // Blue and orange, what was known beforehand paler: after Okabe and Ito. What lies behind
    // touches lets these be seen.
    const auto blue = makeColor(0.0F, 0.447F, 0.698F, 1.0F);
    const auto through_blue = makeColor(0.0F, 0.447F, 0.698F, 0.2F);
    const auto orange = makeColor(0.902F, 0.624F, 0.0F, 1.0F);
    const auto sky_blue = makeColor(0.337F, 0.706F, 0.914F, 1.0F);
    const auto yellow = makeColor(0.941F, 0.894F, 0.259F, 1.0F);
    const Pose here = Pose::Identity();
    draw("touched object", 0, part_.object(), part_.radius(), blue, frames.object, here);
    draw("object behind touches", 0, part_.behindObject(), part_.radius(), through_blue,
         frames.object, here);
    draw("touched world", 0, part_.world(), part_.radius(), orange, frames.world, T_world_map);
    int id = 0;
    for (const KnownBalls& known : part_.knownObject()) {
      draw("known object", id++, known.balls, known.radius, sky_blue, frames.object, here);
    }
    id = 0;
    for (const KnownBalls& known : part_.knownWorld()) {
      draw("known world", id++, known.balls, known.radius, yellow, frames.world, T_world_map);
    }
  }

 private:
  const WorldsAtUnit& part_;
  HypothesisMask world_;
  MarkerArray* array_;
};

/// Yellow for what is unlikely to black for what is certain: light and dark.
std_msgs::ColorRGBA likelihoodColor(double probability) {
  const float rest = 1.0F - static_cast<float>(probability);
  return makeColor(0.941F * rest, 0.894F * rest, 0.259F * rest, 1.0F);
}

Marker label(int number, double unit, const std::string& frame) {
  Marker text = makeMarker(frame, "label", 0, Marker::TEXT_VIEW_FACING);
  text.text = "world " + std::to_string(number) + " of " + std::to_string(kHypotheses);
  text.scale.z = kLetterHeight * unit;
  text.color = makeColor(1.0F, 1.0F, 1.0F, 1.0F);
  text.pose.position.z = 4.0 * text.scale.z;
  text.frame_locked = static_cast<unsigned char>(true);
  return text;
}

}  // namespace

MarkerArray placeMarkers(const Worlds& worlds, const std::string& frame) {
  MarkerArray array;
  Marker marker = makeMarker(frame, "places", 0, Marker::SPHERE_LIST);
  const double size = worlds.feature.radius;
  marker.scale = toScale(size, size, size);
  marker.frame_locked = static_cast<unsigned char>(true);
  for (const auto& [id, in_worlds] : worlds.touched) {
    for (const auto& [place, mask] : placesOf(in_worlds)) {
      marker.points.push_back(toPoint({place[0], place[1], place[2]}));
      marker.colors.push_back(likelihoodColor(SampledWorlds::shareOf(mask)));
    }
  }
  if (marker.points.empty()) marker.action = Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

MarkerArray sampledWorldMarkers(const Worlds& worlds, int number, const FrameNames& frames) {
  MarkerArray array;
  array.markers.push_back(makeMarker(frames.world, "label", 0, Marker::CUBE));
  array.markers.back().action = Marker::DELETEALL;
  if (number < 1 || number > kHypotheses) return array;
  const HypothesisMask world = onlyWorld(number - 1);
  const Pose T_world_map = worlds.frame.T_map_world().inverse();
  for (const WorldsAtUnit& part : worlds.sampled.parts()) {
    WorldDrawing(part, world, &array).drawAll(frames, T_world_map);
  }
  if (array.markers.size() == 1) return array;
  array.markers.push_back(label(number, worlds.unit, frames.object));
  return array;
}

}  // namespace smore
