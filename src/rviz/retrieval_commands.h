// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <optional>
#include <string>

#include "command_runner.h"
#include "smore/common/geometry.h"

namespace smore {

/// What a person can tell the nodes of one namespace to do. Each call returns at once; `answer`
/// says later what became of it.
class RetrievalCommands {
 public:
  /// Names of commands, as people read them.
  static constexpr char kRetrieve[] = "retrieve";
  static constexpr char kPlan[] = "plan only";
  static constexpr char kStop[] = "stop";
  static constexpr char kClear[] = "clear the fault";
  static constexpr char kTare[] = "tare";
  static constexpr char kIdentify[] = "identify the payload";
  static constexpr char kReset[] = "reset the maps";
  static constexpr char kSave[] = "save";
  static constexpr char kLoad[] = "load";

  /// `node`: in the namespace of the nodes.
  explicit RetrievalCommands(const ros::NodeHandle& node);

  /// Begins the scenario's task: a retrieval to its goal, or a reconstruction.
  void retrieve();

  /// Shows the way from where the object is to `goal`, T_world_object; nothing moves.
  void plan(const std::optional<Pose>& goal);

  /// Stops the robot and ends the retrieval. Where the retrieval does not answer in half a second,
  /// the guard stops the robot.
  void stop();

  /// Lets the robot move again after a fault of the guard.
  void clearFault();

  void tare();
  void identifyPayload();
  void resetMaps();

  /// What the maps are made of, as a file of this name in the mapping's folder of beliefs.
  void saveBelief(const std::string& name, bool overwrite);
  void loadBelief(const std::string& name);

  /// Shows voxels of the maps from this probability on, in (0, 1].
  void showFrom(double probability);

  bool running(const std::string& command) const { return runner_.running(command); }
  std::string answer() const { return runner_.answer(); }

 private:
  void trigger(const char* command, const char* service);

  ros::NodeHandle node_;
  ros::Publisher goals_, shown_;
  CommandRunner runner_;
};

}  // namespace smore
