// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/sensor_zero.h"

#include <std_srvs/Trigger.h>

#include "smore/ros/interruptible_call.h"
#include "smore/ros/names.h"

namespace smore {

std::string zeroSensor(ros::NodeHandle* node, const std::string& zero_service, double timeout,
                       const std::function<bool()>& given_up) {
  for (const std::string& name : {zero_service, std::string(names::kListenerTare)}) {
    ros::ServiceClient client = node->serviceClient<std_srvs::Trigger>(name);
    std_srvs::Trigger call;
    if (!waitForService(&client, timeout, given_up)) {
      return "the service '" + client.getService() + "' does not appear; is its node up?";
    }
    if (!callInterruptibly(client, &call, given_up)) call.response.message = "no answer";
    if (call.response.success == 0) {
      return "the service '" + client.getService() + "' failed: " + call.response.message;
    }
  }
  return "";
}

}  // namespace smore
