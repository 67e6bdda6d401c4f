// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include "smore/contact/payload.h"
#include "smore/ros/messages.h"

namespace smore {

/// What happened before the wrench with this stamp, with what the sensor carries since.
smore_msgs::SensingEvent sensingEvent(std::uint8_t kind, const ros::Time& stamp,
                                      const Payload& payload);

Payload payloadOf(const smore_msgs::SensingEvent& event);

}  // namespace smore
