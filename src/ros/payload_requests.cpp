// SPDX-License-Identifier: BSD-3-Clause
#include "payload_requests.h"

#include <ros/console.h>

namespace smore {

bool PayloadRequests::apply(ContactSensing* sensing) {
  const bool identified = identification_.take() && identify(sensing);
  const bool forgotten = forgetting_.take() && forget(sensing);
  return identified || forgotten;
}

bool PayloadRequests::identify(ContactSensing* sensing) {
  const Result<IdentifiedPayload> found = identifyPayload(still_poses_.poses(), axes_);
  const std::string problem = found ? sensing->payloadObjection(*found) : found.reason();
  if (!problem.empty()) {
    identification_.finish({false, problem});
    return false;
  }
  found_ = describe(*found);
  ROS_INFO_STREAM(found_);
  sensing->setPayload(found->payload);
  return true;
}

bool PayloadRequests::forget(ContactSensing* sensing) {
  const std::string problem = sensing->graspObjection();
  if (!problem.empty()) {
    forgetting_.finish({false, problem});
    return false;
  }
  ROS_INFO("the payload is that of the parameters again, and anything beyond it that they allow");
  forgetPoses();
  sensing->setPayload(told_);
  return true;
}

// A contact beyond what the weight may be is none of a pose's wrench. Where no weight is expected,
// a contact may be the weight.
void PayloadRequests::add(const WrenchSample& sample, ContactState state,
                          const ContactSensing& sensing) {
  if (state == ContactState::kContact && sensing.payload().unknown_mass > 0.0) {
    still_poses_.interrupt();
  } else {
    still_poses_.add(sample);
  }
}

void PayloadRequests::finish() {
  identification_.finish({true, found_});
  forgetting_.finish({true, "the payload is that of the parameters again; tared"});
}

}  // namespace smore
