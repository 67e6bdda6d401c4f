// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/marker_parts.h"

#include <algorithm>

#include "smore/ros/conversions.h"

namespace smore {

std_msgs::ColorRGBA makeColor(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = alpha;
  return color;
}

std_msgs::ColorRGBA riskColor(double risk, float alpha) {
  const float share = static_cast<float>(std::clamp(risk, 0.0, 1.0));
  return makeColor(0.6F * share, 1.0F - share, 1.0F - 0.2F * share, alpha);
}

std_msgs::ColorRGBA refusedColor(float alpha) { return makeColor(0.835F, 0.369F, 0.0F, alpha); }

geometry_msgs::Point toPoint(const Vec3& vector) {
  geometry_msgs::Point point;
  point.x = vector.x();
  point.y = vector.y();
  point.z = vector.z();
  return point;
}

geometry_msgs::Vector3 toScale(double x, double y, double z) {
  geometry_msgs::Vector3 scale;
  scale.x = x;
  scale.y = y;
  scale.z = z;
  return scale;
}

visualization_msgs::Marker makeMarker(const std::string& frame, const std::string& space,
                                      std::size_t id, int type) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.ns = space;
  marker.id = static_cast<int>(id);
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose = toMessage(Pose::Identity());
  return marker;
}

}  // namespace smore
