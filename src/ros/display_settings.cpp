// SPDX-License-Identifier: BSD-3-Clause
#include "display_settings.h"

#include "smore/ros/names.h"

namespace smore {
namespace {

MappingConfig toConfig(double min_probability, double line_half_length) {
  MappingConfig config = MappingConfig::__getDefault__();
  config.display_min_probability = min_probability;
  config.line_half_length = line_half_length;
  return config;
}

}  // namespace

DisplaySettings::DisplaySettings(const MappingParameters& parameters)
    : parameters_(toConfig(parameters.display_min_probability, parameters.line_half_length),
                  toConfig(kDisplayProbabilities.min, kLineHalfLengths.min),
                  toConfig(kDisplayProbabilities.max, kLineHalfLengths.max)) {
  node_.setCallbackQueue(parameters_.queue());
  wish_ = node_.subscribe(names::kShownProbability, names::kLatestQueue, &DisplaySettings::onWish,
                          this);
}

void DisplaySettings::onWish(const std_msgs::Float64& message) {
  MappingConfig wish = parameters_.now();
  if (wish.display_min_probability == message.data) return;
  wish.display_min_probability = message.data;
  parameters_.wish(wish);
}

}  // namespace smore
