// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>

#include "smore/ros/conversions.h"
#include "smore/ros/map_keeper.h"
#include "smore/ros/messages.h"

namespace smore {

/// The service `twin_maps`. Callers wait in threads of its own for maps that are new enough, so
/// that no other service of the node waits with them. Fewer may wait than there are threads: one
/// whose maps are there is answered, however many wait.
class TwinMapsService {
 public:
  /// `keeper` must outlive it; `frames`: of the maps.
  TwinMapsService(const FrameNames& frames, const MapKeeper* keeper);

 private:
  static constexpr int kMostWaiting = 7;  // planner, retrieval and what people add to them

  bool onCall(smore_msgs::TwinMaps::Request& request, smore_msgs::TwinMaps::Response& response);
  void fill(const smore_msgs::TwinMaps::Request& request, const MapState& state,
            smore_msgs::TwinMaps::Response* response) const;

  FrameNames frames_;
  const MapKeeper* keeper_;
  std::atomic<int> callers_{0};
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::ServiceServer server_;
  ros::AsyncSpinner threads_{kMostWaiting + 1, &queue_};  ///< the last: they use all above
};

}  // namespace smore
