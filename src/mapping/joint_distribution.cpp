// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_distribution.h"

#include <algorithm>
#include <cmath>

#include "smore/mapping/tempered_population.h"

namespace smore {

JointDistribution::JointDistribution(const std::vector<ContactHypotheses>& contacts,
                                     const FreeSpaceEvidence& evidence,
                                     const DistributionParameters& parameters)
    : contacts_(&contacts), evidence_(&evidence), parameters_(parameters) {}

namespace {

bool conflict(const FreeSpaceEvidence& evidence, int on_object, int i, int in_world, int j) {
  const ConflictTable* table = evidence.conflicts(on_object, in_world);
  return table != nullptr && ((table->by_object[i][j / 64] >> (j % 64)) & 1U) != 0;
}

float kernelOf(const PointArray& a, int i, const PointArray& b, int j, double scale) {
  return attractionKernel((a.at(i) - b.at(j)).squaredNorm() / static_cast<float>(scale * scale));
}

}  // namespace

double JointDistribution::logDensity(const Explanation& explanation) const {
  const auto& contacts = *contacts_;
  const int count = static_cast<int>(contacts.size());
  double log_density = 0.0;
  for (int k = 0; k < count; ++k) {
    const int i = explanation[k];
    if (i == kFalseContact) {
      log_density += std::log(parameters_.false_contact);
      continue;
    }
    log_density += contacts[k].log_prior[i] + std::log1p(-parameters_.false_contact);
    double object = 0.0;
    double world = 0.0;
    for (int l = 0; l < count; ++l) {
      const int j = explanation[l];
      if (j == kFalseContact) continue;
      if (conflict(*evidence_, k, i, l, j)) log_density -= parameters_.conflict_cost;
      if (k == l && conflict(*evidence_, k, i, l, j)) log_density -= parameters_.conflict_cost;
      if (k == l) continue;
      object += kernelOf(contacts[k].object, i, contacts[l].object, j, parameters_.object.scale);
      world += kernelOf(contacts[k].world, i, contacts[l].world, j, parameters_.world.scale);
    }
    log_density += parameters_.exponent * (std::log1p(object / parameters_.object.base) +
                                           std::log1p(world / parameters_.world.base));
  }
  return log_density;
}

std::vector<Explanation> JointDistribution::sample(int count, std::uint64_t seed) const {
  TemperedPopulation population(*contacts_, *evidence_, parameters_, count, seed);
  return population.run();
}

}  // namespace smore
