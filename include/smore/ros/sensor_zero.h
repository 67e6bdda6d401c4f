// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>
#include <string>

namespace smore {

/// Zeroes the wrist sensor by its driver's service (std_srvs/Trigger) and has the listener tare
/// anew. The object must hang free. A driver answers before the zeroing has happened: the tare
/// begins when the mean of the raw wrench is near zero, be it because it was before. Where it does
/// not come there, as when the object swung, it is zeroed again. Waits for each of these up to
/// `timeout` [s of wall time], and no longer than until `given_up` says so; why it failed, else
/// empty.
std::string zeroSensor(ros::NodeHandle* node, const std::string& zero_service, double timeout,
                       const std::function<bool()>& given_up);

}  // namespace smore
