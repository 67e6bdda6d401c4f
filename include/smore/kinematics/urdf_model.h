// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// A robot description (URDF) as urdfdom reads it, which copies share, and where it comes from.
struct UrdfModel {
  urdf::ModelInterfaceSharedPtr model;  ///< never null where it comes from here
  std::string source;                   ///< file or parameter that holds it, for messages

  urdf::ModelInterface* operator->() const { return model.get(); }
};

/// Reads a URDF text; `source` names it in messages. InputError where it is malformed.
UrdfModel parseUrdf(const std::string& xml, const std::string& source);

/// Reads a URDF file. InputError where it cannot be read or is malformed.
UrdfModel loadUrdf(const std::string& file);

/// An arm of scenarios, with its gripper: urdf/ARM_2f85.urdf as it was when this was built.
/// InputError for the Cartesian robot, which has no description.
UrdfModel armUrdf(RobotKind arm);

/// The arm of a scenario: one of those, or that of the file which it names. InputError as above.
UrdfModel armUrdf(const Scenario& scenario);

Pose toPose(const urdf::Pose& pose);

/// The collision shapes of a link that is in `urdf`, in the link's frame. InputError for a mesh,
/// with the remedy.
std::vector<Shape> collisionShapes(const UrdfModel& urdf, const std::string& link);

}  // namespace smore
