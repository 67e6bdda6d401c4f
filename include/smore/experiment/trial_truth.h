// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "smore/common/json.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// What really was, in a file of evidence: for scores alone. No method and no map sees it.
struct TrialTruth {
  std::vector<Shape> object;       ///< perturbed as in the trial, in the object frame
  std::vector<Shape> environment;  ///< the same, in the world
  /// By contact_id, what touched while the contact was measured.
  std::map<int, std::vector<ContactPoint>> contacts;
};

/// Records of the truth (docs/evidence.md).
Json solidsRecord(const Scenario& perturbed);
Json contactTruthRecord(int contact_id, const std::vector<ContactPoint>& points);

/// The truth in a file of evidence, up to its last whole record. InputError for a file that cannot
/// be read or is damaged, and for one without the solids: it was not recorded in simulation.
TrialTruth readTruth(const std::string& file);

}  // namespace smore
