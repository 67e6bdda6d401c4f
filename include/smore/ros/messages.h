// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The package's generated message classes live in namespace `smore`, as its own classes do, and a
// ContactObservation is both. Here the generated ones are renamed to `smore_msgs`; their types on
// the wire stay `smore/...`. What they include comes first, so that nothing else is renamed.
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3.h>
#include <nav_msgs/Path.h>
#include <octomap_msgs/Octomap.h>
#include <ros/message_operations.h>
#include <ros/serialization.h>
#include <ros/service_traits.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#define smore smore_msgs
#include <smore/CheckPose.h>
#include <smore/ContactObservation.h>
#include <smore/Evidence.h>
#include <smore/EvidenceSource.h>
#include <smore/InsertPrior.h>
#include <smore/LineOfAction.h>
#include <smore/LoadBelief.h>
#include <smore/PlanPath.h>
#include <smore/PlanTouch.h>
#include <smore/Prior.h>
#include <smore/RetrieveAction.h>
#include <smore/SaveBelief.h>
#include <smore/SaveMaps.h>
#include <smore/SensingEvent.h>
#include <smore/SensingEvents.h>
#include <smore/TwinMaps.h>
#undef smore
