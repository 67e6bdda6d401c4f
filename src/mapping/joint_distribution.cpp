// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_distribution.h"

#include <algorithm>
#include <cmath>

#include "smore/mapping/tempered_population.h"

namespace smore {

JointDistribution::JointDistribution(const std::vector<ContactHypotheses>& contacts,
                                     const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                                     const DistributionParameters& parameters)
    : contacts_(&contacts), evidence_(&evidence), prior_(&prior), parameters_(parameters) {}

namespace {

struct Side {
  const PointArray& place;
  const PointArray& normal;
};

float kernelOf(const AttractionKernel& kernel, const Side& a, int i, const Side& b, int j) {
  return kernel(a.place.at(i) - b.place.at(j), a.normal.at(i), b.normal.at(j));
}

Side objectOf(const ContactHypotheses& contact) { return {contact.object, contact.object_normal}; }
Side worldOf(const ContactHypotheses& contact) { return {contact.world, contact.world_normal}; }

// Of the pieces of prior knowledge by themselves: their odds, and what they say of one another.
double logDensityOf(const PriorEvidence& prior, PriorMask believed, double conflict_cost) {
  double log_density = 0.0;
  for (int piece = 0; piece < prior.count(); ++piece) {
    const PriorMask bit = PriorMask{1} << piece;
    if ((believed & bit) == 0) continue;
    const PriorMask before = believed & (bit - 1);  // each pair once
    log_density += prior.known(piece).logOdds() - conflict_cost * prior.conflictsOf(piece, before);
  }
  return log_density;
}

}  // namespace

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

double JointDistribution::logDensity(const JointSample& sample) const {
  const Explanation& explanation = sample.places;
  const auto& contacts = *contacts_;
  const int count = static_cast<int>(contacts.size());
  const AttractionKernel on_object(parameters_.object);
  const AttractionKernel in_world(parameters_.world);
  double log_density = logDensityOf(*prior_, sample.believed, parameters_.conflict_cost) -
                       parameters_.conflict_cost * contradictions(explanation, *evidence_);
  for (int k = 0; k < count; ++k) {
    const int i = explanation[k];
    if (i == kFalseContact) {
      log_density += std::log(parameters_.false_contact);
      continue;
    }
    log_density += contacts[k].log_prior[i] + std::log1p(-parameters_.false_contact);
    log_density -= parameters_.conflict_cost * prior_->conflicts(k, i, sample.believed);
    double object = prior_->pull(MapSide::kObject, k, i, sample.believed);
    double world = prior_->pull(MapSide::kWorld, k, i, sample.believed);
    for (int l = 0; l < count; ++l) {
      const int j = explanation[l];
      if (j == kFalseContact) continue;
      if (k == l) continue;
      object += kernelOf(on_object, objectOf(contacts[k]), i, objectOf(contacts[l]), j);
      world += kernelOf(in_world, worldOf(contacts[k]), i, worldOf(contacts[l]), j);
    }
    log_density += parameters_.exponent * (std::log1p(object / parameters_.object.base) +
                                           std::log1p(world / parameters_.world.base));
  }
  return log_density;
}

std::vector<JointSample> JointDistribution::sample(int count, std::uint64_t seed) const {
  TemperedPopulation population(*contacts_, *evidence_, *prior_, parameters_, count, seed);
  return population.run();
}

}  // namespace smore
