// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// ros: nodes and what they share: validate, convert, hand over.

#include <memory>
#include <string>

#include "smore/common/parameters.h"
#include "smore/kinematics/joint_commands.h"
#include "smore/kinematics/urdf_model.h"

namespace smore {

/// The parameter `robot_description` of a node: the name of the global parameter that holds the
/// user's description of the arm; empty where the node has none.
std::string readDescriptionName(ParameterReader* reader);

/// The arm as the parameter of that name describes it (describedArm). The nominal one (armUrdf) for
/// an empty name, and, with a warning, where the parameter is not set within 5 s. InputError where
/// it does not describe this arm.
UrdfModel armByDescription(const Scenario& scenario, const std::string& name);

/// The joint commands of the scenario's robot, an arm by that description.
std::unique_ptr<JointCommands> describedCommands(const Scenario& scenario, const std::string& name);

}  // namespace smore
