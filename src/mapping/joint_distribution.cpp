// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_distribution.h"

#include "smore/mapping/tempered_population.h"

namespace smore {

JointDistribution::JointDistribution(const std::vector<ContactHypotheses>& contacts,
                                     const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                                     const DistributionParameters& parameters)
    : contacts_(&contacts), evidence_(&evidence), prior_(&prior), parameters_(parameters) {}

// A contact's with itself counts twice.
int contradictions(const Explanation& explanation, const FreeSpaceEvidence& evidence) {
  const int count = static_cast<int>(explanation.size());
  int found = 0;
  for (int k = 0; k < count; ++k) {
    for (int l = 0; l < count && explanation[k] != kFalseContact; ++l) {
      if (explanation[l] == kFalseContact) continue;
      const ConflictTable* table = evidence.conflicts(k, l);
      if (table != nullptr && table->at(explanation[k], explanation[l])) found += k == l ? 2 : 1;
    }
  }
  return found;
}

std::vector<JointSample> JointDistribution::sample(int count, std::uint64_t seed) const {
  TemperedPopulation population(*contacts_, *evidence_, *prior_, parameters_, count, seed);
  return population.run();
}

}  // namespace smore
