// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <optional>
#include <string>

#include "smore/common/parameters.h"
#include "smore/retrieval/method.h"
#include "smore/ros/conversions.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// The same value as YAML. Values of types that no parameter of ours has (dates, binary) become
/// null.
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value);

/// All parameters in this node's private namespace as one mapping; empty if there is none.
YAML::Node privateParameters();

/// Reads the optional key `scenario` (a name in the directory `scenario_directory`, or a file).
/// What is wrong with the file is noted in `reader`.
std::optional<Scenario> readScenarioParameter(ParameterReader* reader);

/// Notes an error if the key `scenario` is missing.
void requireScenario(ParameterReader* reader);

/// Reads the key `method`: paper, cspace or smore.
MethodKind readMethod(ParameterReader* reader);

/// `defaults`, changed by the file that the optional key `parameters` names, as the option
/// --parameters of the programs does it (docs/experiments.md). What is wrong with the file is noted
/// in `reader`, and where `method` takes none.
MethodParameters readMethodChanges(ParameterReader* reader, MethodKind method,
                                   const MethodParameters& defaults = {});

/// Reads the keys `world_frame` and `object_frame`.
FrameNames readFrameNames(ParameterReader* reader);

/// Puts the scenario's `value` under `group`.`key` into `mapping`, where the scenario decides on a
/// quantity that is a parameter too. If another value stands there, an error is noted in `reader`.
void imposeScenarioValue(YAML::Node mapping, const std::string& group, const std::string& key,
                         double value, ParameterReader* reader);

/// Initialises ROS as node `name` and calls `run`. An InputError becomes one fatal log message a
/// line and exit code 2, any other exception a message and exit code 1.
int runNode(int argc, char** argv, const std::string& name, const std::function<void()>& run);

}  // namespace smore
