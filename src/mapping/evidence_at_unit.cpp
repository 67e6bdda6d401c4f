// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/evidence_at_unit.h"

#include <algorithm>
#include <cmath>

#include "smore/mapping/object_agreement.h"

namespace smore {

EvidenceAtUnit::EvidenceAtUnit(const JointBeliefParameters& parameters, const MapFrame& frame,
                               double unit, double held)
    : unit_(unit),
      held_(held),
      parameters_(inMetres(parameters, unit, held)),
      frame_(frame),
      free_(parameters_.free_space, parameters_.feature.conflictDistance()) {}

void EvidenceAtUnit::addContact(const ObservedContact& contact) {
  const auto places = contactHypotheses(frame_.T_map_world() * contact.T_world_object, contact.line,
                                        parameters_.feature, frame_.planar());
  if (!places) return;
  // By their ids: sums over contacts then round alike, in whatever order they came.
  const auto after = std::upper_bound(
      contacts_.begin(), contacts_.end(), *places,
      [](const ContactHypotheses& a, const ContactHypotheses& b) { return a.id < b.id; });
  free_.insertContact(static_cast<int>(after - contacts_.begin()), *places);
  contacts_.insert(after, *places);
}

void EvidenceAtUnit::removeContact(std::uint64_t id) {
  const auto found =
      std::find_if(contacts_.begin(), contacts_.end(),
                   [id](const ContactHypotheses& contact) { return contact.id == id; });
  if (found == contacts_.end()) return;
  free_.removeContact(static_cast<int>(found - contacts_.begin()));
  contacts_.erase(found);
}

bool EvidenceAtUnit::knows(std::uint64_t id) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [id](const ContactHypotheses& contact) { return contact.id == id; });
}

DrawnEvidence EvidenceAtUnit::draw(const KnownPieces& known, std::uint64_t seed) const {
  DrawnEvidence result;
  result.prior = PriorEvidence(known, contacts_, free_, parameters_.prior, parameters_.feature,
                               frame_.planar());
  result.samples = JointDistribution(contacts_, free_, result.prior, parameters_.distribution)
                       .sample(kHypotheses, seed);
  return result;
}

UnitEvidence EvidenceAtUnit::evidenceOf(const std::vector<JointSample>& samples,
                                        std::size_t contacts, double widest) const {
  const auto too_far = static_cast<int>(contacts - contacts_.size());
  const TouchLengths lengths{parameters_.distribution.object.scale, parameters_.feature.reach,
                             widest, frame_.planar()};
  return {costOf(samples, too_far), objectAgreement(contacts_, samples, lengths, too_far)};
}

double EvidenceAtUnit::costOf(const std::vector<JointSample>& samples,
                              double false_contacts) const {
  const DistributionParameters& distribution = parameters_.distribution;
  const double of_false_contact = -std::log(distribution.false_contact);
  double cost = of_false_contact * false_contacts;
  for (const JointSample& sample : samples) {
    const auto held_false = std::count(sample.places.begin(), sample.places.end(), kFalseContact);
    cost += (distribution.conflict_cost * contradictions(sample.places, free_) +
             of_false_contact * static_cast<double>(held_false)) /
            static_cast<double>(samples.size());
  }
  return cost;
}

ExplainedEvidence EvidenceAtUnit::explain(const DrawnEvidence& drawn,
                                          const std::vector<int>& members) const {
  ExplainedEvidence result;
  result.prior.evidence = drawn.prior;
  const auto pieces = static_cast<std::size_t>(drawn.prior.count());
  result.explanations.assign(kHypotheses, Explanation(contacts_.size(), kFalseContact));
  result.prior.worlds.assign(pieces, 0);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const JointSample& sample = drawn.samples[i * drawn.samples.size() / members.size()];
    result.explanations[members[i]] = sample.places;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      if (((sample.believed >> piece) & 1U) == 0) continue;
      result.prior.worlds[piece] |= HypothesisMask{1} << members[i];
    }
  }
  return result;
}

void EvidenceAtUnit::tellPlaces(const Explanation& explanation, int m,
                                TouchedPlaces* touched) const {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    std::vector<std::optional<Vec3>>& places = (*touched)[contacts_[k].id];
    places.resize(kHypotheses);
    const int i = explanation[k];
    if (i == kFalseContact) continue;
    const Eigen::Vector3f depth =
        static_cast<float>(parameters_.feature.radius) * contacts_[k].object_normal.at(i);
    places[m] = (contacts_[k].object.at(i) - depth).cast<double>();
  }
}

}  // namespace smore
