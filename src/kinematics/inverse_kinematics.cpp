// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/inverse_kinematics.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace smore {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kTolerance = 1e-9;  // [m] and [rad]
constexpr int kMostSteps = 60;
constexpr double kLongestStep = 0.3;  // of one joint [rad]; beyond, the linear model says nothing
// Damping per squared residual: vanishes with the residual, so that the steps still converge like
// Newton's.
constexpr double kDamping = 1e-2;
constexpr double kSameBranch = 1e-3;  // [rad]
constexpr int kSpreadSeeds = 200;

Vector6 residual(const Pose& T_base_tool, const Pose& T_base_target) {
  const Eigen::AngleAxisd turn(T_base_target.linear() * T_base_tool.linear().transpose());
  Vector6 difference;
  difference << T_base_target.translation() - T_base_tool.translation(), turn.angle() * turn.axis();
  return difference;
}

double difference(const JointVector& a, const JointVector& b) {
  return (a - b).unaryExpr(&wrapped).cwiseAbs().maxCoeff();
}

// Van der Corput's sequence: spreads evenly over [0, 1].
double radicalInverse(int index, int base) {
  double value = 0.0;
  double digit = 1.0;
  for (int rest = index; rest > 0; rest /= base) {
    digit /= base;
    value += digit * (rest % base);
  }
  return value;
}

// Halton's points over all turns of the joints.
std::vector<JointVector> spreadSeeds() {
  constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13};
  std::vector<JointVector> seeds(kSpreadSeeds);
  for (int i = 0; i < kSpreadSeeds; ++i) {
    for (int joint = 0; joint < kArmJoints; ++joint) {
      seeds[static_cast<size_t>(i)][joint] =
          M_PI * (2.0 * radicalInverse(i + 1, kPrimes[joint]) - 1.0);
    }
  }
  return seeds;
}

}  // namespace

InverseKinematics::InverseKinematics(const ArmModel* arm) : arm_(arm), ur_(urGeometry(*arm)) {}

std::vector<JointVector> InverseKinematics::seeds(const Pose& T_base_tool) const {
  return ur_ ? urBranches(*ur_, T_base_tool) : spreadSeeds();
}

std::vector<JointVector> InverseKinematics::branches(const Pose& T_base_tool) const {
  std::vector<JointVector> branches;
  for (const JointVector& seed : seeds(T_base_tool)) {
    const auto solution = solveNear(T_base_tool, seed);
    if (!solution) continue;
    const JointVector q = solution->unaryExpr(&wrapped);
    const bool known = std::any_of(
        branches.begin(), branches.end(),
        [&q](const JointVector& branch) { return difference(branch, q) < kSameBranch; });
    if (!known) branches.push_back(q);
  }
  return branches;
}

std::optional<JointVector> InverseKinematics::solveNear(const Pose& T_base_tool,
                                                        const JointVector& seed) const {
  JointVector q = seed;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector6 error = residual(arm_->toolPose(q), T_base_tool);
    if (error.cwiseAbs().maxCoeff() < kTolerance) return q;
    const ArmJacobian jacobian = arm_->jacobian(q);
    Eigen::Matrix<double, 6, 6> normal = jacobian * jacobian.transpose();
    normal.diagonal().array() += kDamping * error.squaredNorm();
    JointVector change = jacobian.transpose() * normal.ldlt().solve(error);
    const double longest = change.cwiseAbs().maxCoeff();
    if (longest > kLongestStep) change *= kLongestStep / longest;
    q += change;
  }
  return std::nullopt;
}

double InverseKinematics::singularity(const JointVector& q) const {
  const ArmJacobian jacobian = arm_->jacobian(q);
  const Eigen::SelfAdjointEigenSolver<ArmJacobian> squares(jacobian * jacobian.transpose(),
                                                           Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, squares.eigenvalues()[0]));
}

}  // namespace smore
