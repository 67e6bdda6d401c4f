// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/retrieval/retrieval.h"
#include "smore/ros/messages.h"

namespace smore {

/// What is told and kept of one retrieval.
struct RetrievalSummary {
  std::string scenario;
  std::string method;
  double wall_s = 0.0;     ///< wall time [s]
  bool cancelled = false;  ///< the user ended it
  RetrievalOutcome outcome;
};

/// The action's feedback and its result.
smore_msgs::RetrieveFeedback toMessage(const RetrievalProgress& progress);
smore_msgs::RetrieveResult toMessage(const RetrievalOutcome& outcome);

/// For people, a few lines.
std::string toText(const RetrievalSummary& summary);

/// As JSON: scenario, method, success, cancelled, reason, collisions, plans, path_length [m],
/// planning_s, wall_s, and the last planned path as a list of [x, y, z, qx, qy, qz, qw] in the
/// world. False if the file cannot be written.
bool writeJson(const RetrievalSummary& summary, const std::string& file);

}  // namespace smore
