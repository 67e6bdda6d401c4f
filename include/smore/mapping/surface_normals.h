// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace smore {

/// A place where a surface was touched, and its normal as the force there has it.
struct TouchedPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();    ///< [m]
  Eigen::Vector3f normal = Eigen::Vector3f::UnitX();  ///< unit
};

/// How far touches of one flat surface differ; all positive.
struct SurfaceSpread {
  float tilt = 0.0F;    ///< standard deviation of a force from the normal, about either axis [rad]
  float height = 0.0F;  ///< of the places across the surface [m]
  float reach = 0.0F;   ///< touches farther away say nothing [m]
};

/// The normals of the touched surfaces, in the order of the touches. Friction tilts each force, by
/// up to atan(mu), and a surface that is continued along the force leaves its plane soon; where
/// others touched the same surface tells its normal better. So each normal is the likeliest, as the
/// force's tilt is normal and the other touches lie on its plane, up to the spread, or on other
/// surfaces (Geman and McClure's function, by iteratively reweighted least squares), and no further
/// from the force than 1.5 times the tilt's spread. A touch alone keeps its force's direction.
std::vector<Eigen::Vector3f> surfaceNormals(const std::vector<TouchedPoint>& touches,
                                            const SurfaceSpread& spread);

}  // namespace smore
