// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>

#include <optional>
#include <string>

#include "command_runner.h"

namespace smore {

/// What a person can tell the nodes of one namespace to do. Each call returns at once; `answer`
/// says later what became of it.
class RetrievalCommands {
 public:
  /// Names of commands, as people read them.
  static constexpr char kRetrieve[] = "retrieve";
  static constexpr char kPlan[] = "plan only";
  static constexpr char kExecute[] = "execute";
  static constexpr char kStop[] = "stop";
  static constexpr char kClear[] = "clear the fault";
  static constexpr char kTare[] = "tare";
  static constexpr char kIdentify[] = "identify the payload";
  static constexpr char kReset[] = "reset the maps";
  static constexpr char kSave[] = "save";
  static constexpr char kLoad[] = "load";

  /// `node`: in the namespace of the nodes.
  explicit RetrievalCommands(const ros::NodeHandle& node);

  /// A goal, T_world_object; nothing: the scenario's.
  using Goal = std::optional<geometry_msgs::PoseStamped>;

  /// Begins the scenario's task: a retrieval to `goal`, or a reconstruction, which has none.
  void retrieve(const Goal& goal) { begin(kRetrieve, goal); }

  /// Shows the way from where the object is to `goal`; nothing moves.
  void plan(const Goal& goal);

  /// Begins a retrieval to `goal`, the end of a way that has been shown. It plans anew by what is
  /// known then.
  void execute(const Goal& goal) { begin(kExecute, goal); }

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

  /// Shows one of the sampled worlds, by its number, from 1 on; 0: none.
  void showWorld(int number);

  bool running(const std::string& command) const { return runner_.running(command); }
  std::string answer() const { return runner_.answer(); }

 private:
  void begin(const char* command, const Goal& goal);
  void trigger(const char* command, const char* service);

  ros::NodeHandle node_;
  ros::Publisher goals_, shown_, world_;
  CommandRunner runner_;
};

}  // namespace smore
