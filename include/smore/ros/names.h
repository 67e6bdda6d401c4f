// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// Names and queue sizes of everything that the nodes exchange, once. All names are relative, so
/// that they can be remapped and put into a namespace; docs/ros_interface.md describes each.
namespace smore::names {

constexpr char kWrench[] = "wrench";
constexpr char kWrenchCompensated[] = "wrench_compensated";
constexpr char kContact[] = "contact";
constexpr char kSensingEvents[] = "sensing_events";
constexpr char kEvidenceSource[] = "evidence_source";
constexpr char kCommand[] = "command";
constexpr char kSignOfLife[] = "command_attended";
constexpr char kGuardedCommand[] = "guarded_command";
constexpr char kControllerState[] = "controller_state";
constexpr char kProgramRunning[] = "robot_program_running";
constexpr char kSafetyMode[] = "safety_mode";
constexpr char kSpeedScaling[] = "speed_scaling_factor";
constexpr char kJointStates[] = "joint_states";
constexpr char kScene[] = "scene";
constexpr char kClock[] = "/clock";
constexpr char kTf[] = "/tf";
constexpr char kTfStatic[] = "/tf_static";

constexpr char kWorldMap[] = "world";
constexpr char kObjectMap[] = "object";
constexpr char kOctomapFull[] = "octomap_full";
constexpr char kOctomapBinary[] = "octomap_binary";
constexpr char kOctomapWithPose[] = "octomap_with_pose";
constexpr char kPointCloud[] = "octomap_point_cloud_centers";
constexpr char kOccupiedCells[] = "occupied_cells_vis_array";
constexpr char kShownProbability[] = "shown_probability";
constexpr char kContactLines[] = "contact_lines";
constexpr char kContactPlaces[] = "contact_places";
constexpr char kSampledWorld[] = "sampled_world";
constexpr char kShownWorld[] = "shown_world";

constexpr char kTwinMaps[] = "twin_maps";
constexpr char kResetMaps[] = "reset";
constexpr char kSaveMaps[] = "save_maps";
constexpr char kSaveBelief[] = "save_belief";
constexpr char kLoadBelief[] = "load_belief";
constexpr char kInsertPrior[] = "insert_prior";
constexpr char kTare[] = "tare";                         ///< in the listener's private namespace
constexpr char kSuspend[] = "suspend";                   ///< there too
constexpr char kIdentifyPayload[] = "identify_payload";  ///< there too
constexpr char kForgetPayload[] = "forget_payload";      ///< there too
constexpr char kGuardFault[] = "guard/fault";
constexpr char kGuardStop[] = "guard/stop";
constexpr char kGuardClear[] = "guard/clear";
constexpr char kListenerTare[] = "force_torque/tare";
constexpr char kListenerSuspend[] = "force_torque/suspend";
constexpr char kListenerIdentifyPayload[] = "force_torque/identify_payload";
constexpr char kResetSimulator[] = "reset";  ///< in the simulator's private namespace

constexpr char kPlanPath[] = "plan_path";
constexpr char kPlanTouch[] = "plan_touch";
constexpr char kCheckPose[] = "check_pose";
constexpr char kPath[] = "path";
constexpr char kPathMarkers[] = "path_risk";
constexpr char kPathGhost[] = "path_ghost";
constexpr char kPlanTree[] = "plan_tree";
constexpr char kGoalMarker[] = "goal_marker";
constexpr char kMarkedGoal[] = "marked_goal";

constexpr char kRetrieve[] = "retrieve";
constexpr char kStop[] = "stop";    ///< in the guard's private namespace too
constexpr char kClear[] = "clear";  ///< in the guard's private namespace
constexpr char kFault[] = "fault";  ///< the same

/// Sensor streams: 2 s at 500 Hz, so that a listener that is late for a moment loses nothing.
constexpr std::uint32_t kStreamQueue = 1000;
/// Observations on their way into the maps: none may be lost while a belief update runs.
constexpr std::uint32_t kObservationQueue = 100000;
/// Commands, maps, markers: the newest counts.
constexpr std::uint32_t kLatestQueue = 1;

}  // namespace smore::names
