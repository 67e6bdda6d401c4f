// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/settled_maps.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "smore/ros/messages.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

constexpr double kStill = 0.1;     // of observations that change nothing [s]
constexpr double kPatience = 2.0;  // [s of wall time]

/// Of maps that hold all observations up to `stamp` [s]; nothing where they do not come in time.
std::optional<std::uint64_t> revisionAt(ros::ServiceClient* maps, double stamp,
                                        const ros::WallTime& deadline) {
  smore_msgs::TwinMaps call;
  call.request.not_before.fromSec(stamp);
  const double left = (deadline - ros::WallTime::now()).toSec();
  call.request.timeout = ros::Duration(std::max(0.0, left));
  if (!maps->call(call) || call.response.success == 0) return std::nullopt;
  return call.response.revision;
}

void waitUntilSettled(ros::NodeHandle* node, double felt) {
  ros::ServiceClient maps = node->serviceClient<smore_msgs::TwinMaps>(names::kTwinMaps);
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  std::optional<std::uint64_t> before = revisionAt(&maps, felt, deadline);
  while (before) {
    felt += kStill;
    const std::optional<std::uint64_t> after = revisionAt(&maps, felt, deadline);
    if (after == before) return;
    before = after;
  }
}

}  // namespace

std::string saveSettledMaps(ros::NodeHandle* node, double felt, const std::string& directory) {
  waitUntilSettled(node, felt);
  ros::ServiceClient saving = node->serviceClient<smore_msgs::SaveMaps>(names::kSaveMaps);
  smore_msgs::SaveMaps call;
  call.request.directory = directory;
  if (!saving.call(call)) return "the mapping node does not answer";
  return call.response.success != 0 ? "" : call.response.message;
}

}  // namespace smore
