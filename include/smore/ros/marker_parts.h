// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <cstddef>
#include <string>

#include "smore/common/geometry.h"

namespace smore {

/// A colour; each part in [0, 1].
std_msgs::ColorRGBA makeColor(float red, float green, float blue, float alpha);

/// The colour of a risk in [0, 1], wherever one is shown: cyan for 0 to purple for 1, as the
/// paper's figure 5 has it. The colour-blind tell them apart, as light and dark.
std_msgs::ColorRGBA riskColor(double risk, float alpha = 1.0F);

/// The colour of what is not allowed: vermillion, after Okabe and Ito (Color universal design,
/// 2008).
std_msgs::ColorRGBA refusedColor(float alpha = 1.0F);

geometry_msgs::Point toPoint(const Vec3& vector);
geometry_msgs::Vector3 toScale(double x, double y, double z);

/// A marker of this `type` at the origin of `frame`, stamped 0: valid at all times.
visualization_msgs::Marker makeMarker(const std::string& frame, const std::string& space,
                                      std::size_t id, int type);

}  // namespace smore
