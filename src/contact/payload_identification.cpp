// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/payload_identification.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace smore {
namespace {

constexpr size_t kLeastPoses = 3;
constexpr double kLeastTilt = 0.2;          // [rad]
constexpr double kMostForceResidual = 1.0;  // [N]; noise and drift leave less
// Where a controller has been told too much, it takes off this much more at most [kg].
constexpr double kMostNegativeMass = 0.5;
constexpr double kMostTorqueResidual = 0.1;  // [N m]
// Where the residuals are a share of what is allowed that noise and drift do not explain, other
// axes are looked at; they are right where they leave so many times less.
constexpr double kWorthALook = 0.25;
constexpr double kClearlyBetter = 3.0;

struct Fit {
  Vec3 bias;
  Eigen::VectorXd unknowns;
  double residual = 0.0;  // root mean square
};

/// Three equations a pose, docs/sensing.md (S4): observed = bias + response * unknowns.
class LeastSquares {
 public:
  LeastSquares(size_t poses, Eigen::Index unknowns)
      : design_(3 * poses, 3 + unknowns), observed_(3 * poses) {}

  void add(const Vec3& observed, const Eigen::MatrixXd& response) {
    design_.block<3, 3>(row_, 0).setIdentity();
    design_.block(row_, 3, 3, response.cols()) = response;
    observed_.segment<3>(row_) = observed;
    row_ += 3;
  }

  Fit solve() const {
    const Eigen::VectorXd solution = design_.colPivHouseholderQr().solve(observed_);
    const double squares = (design_ * solution - observed_).squaredNorm();
    return {solution.head<3>(), solution.tail(solution.size() - 3),
            std::sqrt(squares / static_cast<double>(observed_.size()))};
  }

 private:
  Eigen::MatrixXd design_;
  Eigen::VectorXd observed_;
  Eigen::Index row_ = 0;
};

double tiltOf(const std::vector<StillWrench>& poses) {
  const double count = static_cast<double>(poses.size());
  Vec3 mean = Vec3::Zero();
  for (const StillWrench& pose : poses) mean += gravityIn(pose.T_world_object).normalized() / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const StillWrench& pose : poses) {
    const Vec3 moved = gravityIn(pose.T_world_object).normalized() - mean;
    scatter += moved * moved.transpose() / count;
  }
  const Vec3 squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
  return std::sqrt(std::max(0.0, squares[0] + squares[1]));
}

std::string poseProblem(const std::vector<StillWrench>& poses) {
  std::ostringstream problem;
  if (poses.size() < kLeastPoses) {
    problem << "a payload needs " << kLeastPoses << " still poses at least, and there are "
            << poses.size() << "; tilt the object about two horizontal axes";
  } else if (const double tilt = tiltOf(poses); tilt < kLeastTilt) {
    problem << "the " << poses.size() << " poses are too similar: a tilt of " << tilt
            << " rad, and " << kLeastTilt
            << " rad are needed; tilt the object further, about two horizontal axes";
  }
  return problem.str();
}

std::string fitProblem(const IdentifiedPayload& found) {
  std::ostringstream problem;
  if (!(found.payload.mass >= -kMostNegativeMass)) {
    problem
        << "the payload's mass would be " << found.payload.mass
        << " kg; check the wrench's sign (what acts on the object: weight points down), that the "
           "world's z axis points up, and what payload the controller takes off";
  } else if (found.force_residual > kMostForceResidual ||
             found.torque_residual > kMostTorqueResidual) {
    problem << "no payload explains the wrenches: " << found.force_residual << " N and "
            << found.torque_residual << " N m are left over, allowed " << kMostForceResidual
            << " N and " << kMostTorqueResidual
            << " N m; free the object on all sides and tilt it anew";
  }
  return problem.str();
}

// As if the sensor's wrenches were the driver's in `axes`.
IdentifiedPayload fitPayload(const std::vector<StillWrench>& poses, const WrenchAxes& axes) {
  LeastSquares forces(poses.size(), 1);
  LeastSquares torques(poses.size(), 3);
  for (const StillWrench& pose : poses) {
    const Vec3 gravity = gravityIn(pose.T_world_object);
    const Eigen::Matrix3d turn =
        axes.sign * pose.sensor_axes_object * axes.turn * pose.sensor_axes_object.transpose();
    forces.add(turn * pose.mean.force, gravity);
    torques.add(turn * (pose.mean.torque - pose.sensor_object.cross(pose.mean.force)),
                -crossMatrix(gravity));
  }
  const Fit force = forces.solve();
  const Fit torque = torques.solve();
  IdentifiedPayload found;
  const double mass = force.unknowns[0];
  found.payload = {mass, mass * poses.back().sensor_object + torque.unknowns};
  found.sensor_bias = {force.bias, torque.bias};
  found.force_residual = force.residual;
  found.torque_residual = torque.residual;
  return found;
}

// Of the residuals to what is allowed.
double misfitOf(const IdentifiedPayload& found) {
  return std::max(found.force_residual / kMostForceResidual,
                  found.torque_residual / kMostTorqueResidual);
}

// The axes with which gravity fits so much better than with the present ones that these are wrong;
// nothing where it does not.
std::optional<WrenchAxes> axesThatFitBetter(const std::vector<StillWrench>& poses,
                                            const IdentifiedPayload& found) {
  const bool refused = !fitProblem(found).empty();
  double least = refused ? 1.0 : misfitOf(found) / kClearlyBetter;
  if (!refused && misfitOf(found) < kWorthALook) return std::nullopt;
  std::optional<WrenchAxes> best;
  for (const WrenchAxes& axes : allWrenchAxes()) {
    const IdentifiedPayload other = fitPayload(poses, axes);
    if (other.payload.mass <= 0.0 || misfitOf(other) >= least) continue;
    best = axes;
    least = misfitOf(other);
  }
  return best;
}

}  // namespace

std::string describe(const IdentifiedPayload& found) {
  constexpr double kLeastMass = 0.05;  // [kg]; of less the centre is not known to a decimetre
  const Payload& payload = found.payload;
  std::ostringstream text;
  text << "the payload is " << payload.mass << " kg ";
  if (payload.mass < kLeastMass) {
    text << "with a moment of (" << payload.moment_object.transpose() << ") kg m";
  } else {
    text << "at (" << (payload.moment_object / payload.mass).transpose() << ") m";
  }
  text << " in the object frame; " << found.force_residual << " N and " << found.torque_residual
       << " N m are left over";
  return text.str();
}

std::vector<Pose> payloadTilts(const Pose& level, double tilt) {
  std::vector<Pose> poses;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    for (const double angle : {tilt, -tilt}) {
      Pose tilted = level;
      tilted.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * level.linear();
      poses.push_back(tilted);
    }
  }
  return poses;
}

Result<IdentifiedPayload> identifyPayload(const std::vector<StillWrench>& poses,
                                          const WrenchAxes& told) {
  if (const std::string problem = poseProblem(poses); !problem.empty()) return Failure{problem};
  IdentifiedPayload found = fitPayload(poses, WrenchAxes());
  std::string problem = fitProblem(found);
  if (const auto better = axesThatFitBetter(poses, found)) {
    if (problem.empty()) problem = "the weight points elsewhere than gravity";
    problem += "; it fits with the sensor's parameters " + toText(compose(*better, told));
  }
  if (!problem.empty()) return Failure{problem};
  return found;
}

}  // namespace smore
