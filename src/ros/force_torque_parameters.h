// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "smore/contact/contact_sensing.h"
#include "smore/contact/wrench_axes.h"
#include "smore/kinematics/wrist_sensor.h"
#include "smore/ros/conversions.h"

namespace smore {

struct ForceTorqueParameters {
  FrameNames frames;
  WrenchAxes axes;                 ///< of the sensor's driver
  double transform_timeout = 0.5;  ///< sample time that a wrench waits for its pose [s]
  double silence_timeout = 2.0;    ///< wall time without a wrench before a warning [s]
  double tare_timeout = 10.0;      ///< wall time that the services wait [s]
  ContactSensingParameters sensing;
  WrenchRange range;   ///< of the scenario's arm
  std::string record;  ///< bag of what is taken; empty: none
};

/// Reads the parameters of config/force_torque.yaml, with what a scenario fixes taken from it.
/// InputError with every problem; `source` names the node in it.
ForceTorqueParameters readForceTorqueParameters(const YAML::Node& mapping,
                                                const std::string& source);

/// The same with everything that follows from the scenario, as YAML without a scenario: it is read
/// as the same parameters anywhere.
std::string toYaml(const ForceTorqueParameters& parameters, const YAML::Node& mapping);

}  // namespace smore
