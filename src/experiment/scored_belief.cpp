// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/scored_belief.h"

#include "smore/planning/contact_risk.h"
#include "smore/planning/fresh_cells.h"

namespace smore {

ScoredBelief::ScoredBelief(const Scenario& task, const MethodParameters& parameters,
                           std::uint64_t seed, const Priors& priors)
    : method_(makeMethod(MethodKind::kSmore, task, seed, parameters, priors)),
      belief_(dynamic_cast<JointBelief*>(method_.maps.get())) {}

double ScoredBelief::riskOf(const Path& path) const {
  return ContactRisk(belief_->worlds()).ofMotion(path);
}

double ScoredBelief::touchingShare(const Path& path) const {
  return ContactRisk(belief_->worlds()).along(path);
}

std::vector<double> ScoredBelief::survival(const std::vector<Path>& legs) const {
  const ContactRisk risk(belief_->worlds());
  const FreeSpaceParameters& cell = risk.worlds().free.parameters();
  HypothesisMask touched = 0;
  FreshCells fresh(risk.worlds());
  std::vector<double> survival;
  for (const Path& leg : legs) {
    touched |= risk.touchingAlong(leg);
    for (const Pose& pose : densify(leg, cell.position_cell, cell.angle_cell)) fresh.enter(pose);
    const double part = static_cast<double>(survival.size() + 1) / static_cast<double>(legs.size());
    const double share =
        (kHypotheses * SampledWorlds::shareOf(touched) + 0.5 * part) / (kHypotheses + 1.0);
    survival.push_back((1.0 - share) * risk.noSurpriseIn(fresh.count()));
  }
  return survival;
}

std::vector<std::optional<Vec3>> ScoredBelief::placesOf(const ContactObservation& contact) const {
  if (!contact.line) return {};
  return belief_->placesOf(contact.T_world_object, *contact.line);
}

}  // namespace smore
