// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/belief_display.h"

#include <visualization_msgs/MarkerArray.h>

#include <utility>

#include "smore/mapping/joint_belief.h"
#include "smore/ros/belief_markers.h"
#include "smore/ros/scene_markers.h"

namespace smore {

std::shared_ptr<const Worlds> worldsOf(const TwinMap& maps) {
  const auto* belief = dynamic_cast<const JointBelief*>(&maps);
  return belief == nullptr ? nullptr : belief->worlds();
}

BeliefDisplay::BeliefDisplay(const ros::NodeHandle& node, const FrameNames& frames,
                             double voxel_size)
    : frames_(frames), voxel_size_(voxel_size), node_(node) {
  lines_.open<visualization_msgs::MarkerArray>(&node_, names::kContactLines);
  places_.open<visualization_msgs::MarkerArray>(&node_, names::kContactPlaces);
  world_.open<visualization_msgs::MarkerArray>(&node_, names::kSampledWorld);
  wish_ = node_.subscribe(names::kShownWorld, names::kLatestQueue, &BeliefDisplay::onWish, this);
}

bool BeliefDisplay::isDue(std::uint64_t revision) {
  const int wished = wished_;
  if (std::exchange(shown_, wished) != wished) world_.renew();
  return places_.isDue(revision) || world_.isDue(revision);
}

void BeliefDisplay::publish(const Worlds& worlds, std::uint64_t revision) {
  places_.send(revision, [&] { return placeMarkers(worlds, frames_.object); });
  world_.send(revision, [&] { return sampledWorldMarkers(worlds, shown_, frames_); });
}

void BeliefDisplay::publish(const std::vector<LineOfAction>& lines, std::uint64_t epoch,
                            double half_length) {
  if (std::exchange(half_length_, half_length) != half_length) lines_.renew();
  if (std::exchange(epoch_, epoch) != epoch) lines_.renew();
  lines_.send(lines.size(), [&] { return lineMarkers(lines, half_length, voxel_size_, frames_); });
}

void BeliefDisplay::onWish(const std_msgs::Int32& message) {
  if (message.data >= 0 && message.data <= kHypotheses) {
    wished_ = message.data;
  } else {
    ROS_WARN_STREAM("'" << wish_.getTopic() << "' says " << message.data
                        << ": give the number of a world, from 1 to " << kHypotheses
                        << ", or 0 for none");
  }
}

}  // namespace smore
