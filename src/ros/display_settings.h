// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <smore/MappingConfig.h>
#include <std_msgs/Float64.h>

#include "dynamic_parameters.h"
#include "mapping_parameters.h"

namespace smore {

/// What somebody who looks at the maps may choose while the mapping runs: by dynamic_reconfigure,
/// and the probability on the topic `shown_probability` too; from any thread.
class DisplaySettings {
 public:
  explicit DisplaySettings(const MappingParameters& parameters);

  /// From which on voxels are shown, in (0, 1].
  double minProbability() const { return parameters_.now().display_min_probability; }

  /// Of the lines of action [m].
  double lineHalfLength() const { return parameters_.now().line_half_length; }

 private:
  void onWish(const std_msgs::Float64& message);

  DynamicParameters<MappingConfig> parameters_;
  ros::NodeHandle node_;
  ros::Subscriber wish_;
};

}  // namespace smore
