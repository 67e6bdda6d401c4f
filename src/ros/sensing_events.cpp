// SPDX-License-Identifier: BSD-3-Clause
#include "sensing_events.h"

namespace smore {

smore_msgs::SensingEvent sensingEvent(std::uint8_t kind, const ros::Time& stamp,
                                      const Payload& payload) {
  smore_msgs::SensingEvent event;
  event.kind = kind;
  event.stamp = stamp;
  event.mass = payload.mass;
  event.moment.x = payload.moment_object.x();
  event.moment.y = payload.moment_object.y();
  event.moment.z = payload.moment_object.z();
  event.unknown_mass = payload.unknown_mass;
  return event;
}

Payload payloadOf(const smore_msgs::SensingEvent& event) {
  return {event.mass, {event.moment.x, event.moment.y, event.moment.z}, event.unknown_mass};
}

}  // namespace smore
