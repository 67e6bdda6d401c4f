// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_msgs/Int32.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "smore/contact/line_of_action.h"
#include "smore/mapping/twin_map.h"
#include "smore/mapping/worlds.h"
#include "smore/ros/conversions.h"
#include "smore/ros/revised_topic.h"

namespace smore {

/// What the maps are the marginals of; null where their method samples no worlds.
std::shared_ptr<const Worlds> worldsOf(const TwinMap& maps);

/// What a mapping believes, for the eye, each on a topic that sends only what somebody looks at and
/// what has changed: lines of action, the places where each contact may have been, and that of the
/// sampled worlds which somebody asks for on `shown_world`.
class BeliefDisplay {
 public:
  /// Beside voxels of `voxel_size` [m]. The queue of `node` is called by who serves it.
  BeliefDisplay(const ros::NodeHandle& node, const FrameNames& frames, double voxel_size);

  /// Whether somebody looks at worlds or places of which not this revision was sent.
  bool isDue(std::uint64_t revision);

  /// Sends what is due of the worlds of this revision.
  void publish(const Worlds& worlds, std::uint64_t revision);

  /// Sends the lines, given in the object frame, `half_length` [m] to either side, where there are
  /// more than before, they are of another log (EvidenceLog::epoch), or longer or shorter.
  void publish(const std::vector<LineOfAction>& lines, std::uint64_t epoch, double half_length);

 private:
  void onWish(const std_msgs::Int32& message);

  FrameNames frames_;
  double voxel_size_;
  double half_length_ = 0.0;  ///< of the lines that were sent last [m]
  std::uint64_t epoch_ = 0;   ///< of their log
  ros::NodeHandle node_;
  std::atomic<int> wished_{0};  ///< number of the world to be shown; 0: none
  int shown_ = 0;               ///< that was shown last
  RevisedTopic lines_, places_, world_;
  ros::Subscriber wish_;
};

}  // namespace smore
