// SPDX-License-Identifier: BSD-3-Clause
#include "sensing_replay.h"

#include <utility>

#include "sensing_events.h"

namespace smore {

using Event = smore_msgs::SensingEvent;

SensingReplay::SensingReplay(const ForceTorqueParameters& parameters, std::vector<Event> events,
                             OnObservation on_observation)
    : parameters_(parameters),
      events_(std::move(events)),
      on_observation_(std::move(on_observation)),
      sensing_(parameters.sensing),
      intake_(
          parameters, [this] { restart(); },
          [this](const WrenchSample& sample, const ros::Time& stamp) { process(sample, stamp); }) {}

void SensingReplay::take(const tf2_msgs::TFMessage& message, bool is_static) {
  is_static ? intake_.onStaticTransforms(message) : intake_.onTransforms(message);
  intake_.handOn();
}

// What was noted before time went back is over.
void SensingReplay::restart() {
  sensing_ = ContactSensing(parameters_.sensing);
  while (next_event_ < events_.size() && events_[next_event_].kind != Event::RESET) ++next_event_;
  if (next_event_ < events_.size()) ++next_event_;
}

void SensingReplay::process(const WrenchSample& sample, const ros::Time& stamp) {
  const bool before_start = next_event_ == 0 && !events_.empty() && stamp < events_.front().stamp;
  if (before_start) return;
  if (begin_.isZero()) begin_ = stamp;
  applyEvents(stamp);
  const Result<ContactObservation> observation = sensing_.process(sample);
  if (!observation) return;  // of an unsure one no map learns
  smore_msgs::ContactObservation message = toMessage(*observation, parameters_.frames);
  message.header.stamp = stamp;
  const Result<ContactObservation> received = fromMessage(message);  // to the bit as over the wire
  if (received) on_observation_(*received);
}

void SensingReplay::applyEvents(const ros::Time& stamp) {
  for (; next_event_ < events_.size(); ++next_event_) {
    const Event& event = events_[next_event_];
    if (event.kind == Event::RESET || event.stamp > stamp) return;
    if (event.kind == Event::TARE) sensing_.startTare();
    if (event.kind == Event::SUSPEND) sensing_.suspend();
    if (event.kind != Event::PAYLOAD) continue;
    parameters_.sensing.payload = payloadOf(event);
    sensing_.setPayload(parameters_.sensing.payload);
  }
}

}  // namespace smore
