// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "smore/scenario/motion_space.h"

namespace smore {

/// Corrects the risks that a planner states by what came of its motions so far.
///
/// Plans are chosen for their low risk, and worlds lack what nobody has touched: so stated risks
/// may be too low, in space most of all, by an amount that differs between scenes. The odds of a
/// contact are taken to be those that were stated times a factor that is the same for all motions
/// of a run, inferred from them. In space odds above even ones count by their fourth root, since
/// most worlds touching tells little more there than half of them: docs/planning.md (P2).
class RiskCalibration {
 public:
  explicit RiskCalibration(Motion motion);

  /// Probability of a contact for a motion whose plan states `risk`, both in [0, 1]. What is stated
  /// to be certain stays so.
  double corrected(double risk) const;

  /// A motion whose plan stated `risk` touched, or did not. What was stated to be certain teaches
  /// nothing.
  void learn(double risk, bool touched);

 private:
  static constexpr int kShifts = 81;
  static double shift(int index);
  double logOdds(double risk) const;  ///< of a stated risk in (0, 1), as they count

  Motion motion_;
  std::array<double, kShifts> weights_{};  ///< of the shifts of the log odds; they sum to 1
};

}  // namespace smore
