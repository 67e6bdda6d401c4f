// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/controller_watch.h"

#include <topic_tools/shape_shifter.h>

#include <algorithm>

#include "smore/ros/names.h"

namespace smore {
namespace {

// A controller that runs tells its state far more often, and a motion that it does not follow has
// not come far by then [s of wall time].
constexpr double kSilence = 0.3;

// Between looks whether anybody tells it [s of wall time]: who has just come has not told it yet.
constexpr double kLookPeriod = 0.1;

}  // namespace

// That something comes is all that is asked, so that no definition of its type is needed: Debian
// has no control_msgs.
ControllerWatch::ControllerWatch(ros::CallbackQueue* queue, const ros::Publisher& commands)
    : commands_(commands) {
  node_.setCallbackQueue(queue);
  const boost::function<void(const topic_tools::ShapeShifter&)> on_state =
      [this](const topic_tools::ShapeShifter& /*state*/) {
        last_state_ = ros::SteadyTime::now().toSec();
      };
  state_ = node_.subscribe<topic_tools::ShapeShifter>(names::kControllerState, names::kLatestQueue,
                                                      on_state, ros::VoidConstPtr(),
                                                      ros::TransportHints().tcpNoDelay());
  looks_ = node_.createSteadyTimer(ros::WallDuration(kLookPeriod),
                                   [this](const ros::SteadyTimerEvent& /*event*/) {
                                     if (state_.getNumPublishers() == 0)
                                       nobody_at_ = ros::SteadyTime::now().toSec();
                                   });
}

std::string ControllerWatch::problem(double now) const {
  const std::string commands = "'" + commands_.getTopic() + "'";
  if (commands_.getNumSubscribers() == 0) {
    return "nobody listens to commands on " + commands +
           "; is the robot's driver up, and its controller loaded (controller_manager/"
           "list_controllers)?";
  }
  const bool silent = now - std::max(last_state_, nobody_at_) > kSilence;
  if (state_.getNumPublishers() > 0 && silent) {
    return "the controller that gets the commands on " + commands +
           " is loaded but does not run: nothing comes on '" + state_.getTopic() +
           "'; start it (controller_manager/switch_controller)";
  }
  return "";
}

}  // namespace smore
