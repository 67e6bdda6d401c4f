// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/result.h"
#include "smore/contact/contact_observation.h"
#include "smore/contact/payload.h"
#include "smore/contact/wrench_axes.h"

namespace smore {

/// The mean of raw wrenches at one pose at which the robot stood still and touched nothing.
struct StillWrench {
  double time = 0.0;  ///< of the newest sample [s]
  Wrench mean;        ///< at the origin and in the axes of the object frame, bias and weight in it
  Pose T_world_object = Pose::Identity();
  Vec3 sensor_object = Vec3::Zero();  ///< the sensor's origin in the object frame [m]
  Eigen::Matrix3d sensor_axes_object =
      Eigen::Matrix3d::Identity();  ///< the sensor's axes in the object frame, as columns
};

struct IdentifiedPayload {
  Payload payload;
  Wrench sensor_bias;            ///< about the sensor's origin, in the axes of the object frame
  double force_residual = 0.0;   ///< root mean square over poses and axes [N]
  double torque_residual = 0.0;  ///< the same about the sensor's origin [N m]
};

/// What was found, in words.
std::string describe(const IdentifiedPayload& found);

/// The pose `level` turned by `tilt` [rad] to and fro about the world's x and y axes, the origin
/// staying where it is.
std::vector<Pose> payloadTilts(const Pose& level, double tilt);

/// Mass, moment (mass times centre of mass) and sensor bias by least squares.
///
/// With gravity g_i in the object's axes at pose i, and all torques about the sensor's origin s,
///   F_i = b_F + m g_i,    T_i = b_T + m (c - s) x g_i,
/// linear in (b_F, m) and in (b_T, m (c - s)). What tells weight from bias is how gravity moves
/// through the object's axes: the moment about the axis seen worst is known to
/// torque_error / (9.81 sqrt(n) tilt), where tilt [rad] is the root mean square of gravity's
/// distance from its mean over the n poses, in the two directions in which it moved least.
///
/// A failure, with the remedy: fewer than three poses; a tilt below 0.2 rad (five poses, level and
/// turned by 0.32 rad to and fro about two horizontal axes, have it); a mass below -0.5 kg (small
/// masses of either sign are left where a controller takes off the payload that was set there); a
/// residual of more than 1 N or 0.1 N m (something touched, or the robot moved). Where gravity then
/// fits wrenches of another sign or in other axes of the sensor, the reason says with which
/// parameters; `told` are the present ones, which the wrenches have behind them.
Result<IdentifiedPayload> identifyPayload(const std::vector<StillWrench>& poses,
                                          const WrenchAxes& told = {});

}  // namespace smore
