// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/gibbs_chain.h"

#include <algorithm>
#include <cmath>

namespace smore {

GibbsChain::Side::Side(std::size_t contacts, const AttractionParameters& attraction)
    : kernel(attraction),
      base(static_cast<float>(attraction.base)),
      centers(contacts, Eigen::Vector3f::Zero()),
      normals(contacts, Eigen::Vector3f::Zero()),
      sums(contacts, 0.0F) {}

void GibbsChain::Side::place(int contact, const PointArray& places, const PointArray& its_normals,
                             int place) {
  centers[contact] = places.at(place);
  normals[contact] = its_normals.at(place);
  sums[contact] = 0.0F;
}

float GibbsChain::Side::between(int a, int b) const {
  return kernel(centers[a] - centers[b], normals[a], normals[b]);
}

GibbsChain::GibbsChain(const std::vector<ContactHypotheses>& contacts,
                       const FreeSpaceEvidence& evidence, const DistributionParameters& parameters)
    : contacts_(&contacts),
      evidence_(&evidence),
      parameters_(&parameters),
      places_(contacts.size(), kFalseContact),
      object_(contacts.size(), parameters.object),
      world_(contacts.size(), parameters.world) {}

void GibbsChain::changeSums(int contact, float sign) {
  for (Side* side : {&object_, &world_}) {
    for (std::size_t l = 0; l < contacts_->size(); ++l) {
      if (places_[l] == kFalseContact || static_cast<int>(l) == contact) continue;
      const float kernel = side->between(static_cast<int>(l), contact);
      side->sums[l] = std::max(0.0F, side->sums[l] + sign * kernel);
      side->sums[contact] += kernel;
    }
  }
}

void GibbsChain::remove(int contact) {
  if (places_[contact] == kFalseContact) return;
  changeSums(contact, -1.0F);
  places_[contact] = kFalseContact;
}

void GibbsChain::add(int contact, int place) {
  places_[contact] = static_cast<std::int16_t>(place);
  if (place == kFalseContact) return;
  const ContactHypotheses& touched = (*contacts_)[contact];
  object_.place(contact, touched.object, touched.object_normal, place);
  world_.place(contact, touched.world, touched.world_normal, place);
  changeSums(contact, 1.0F);
}

double GibbsChain::binding() const {
  double log_attraction = 0.0;
  int conflicts = 0;
  for (std::size_t k = 0; k < contacts_->size(); ++k) {
    if (places_[k] == kFalseContact) continue;
    log_attraction +=
        std::log1p(object_.sums[k] / object_.base) + std::log1p(world_.sums[k] / world_.base);
    for (std::size_t l = 0; l < contacts_->size(); ++l) {
      if (places_[l] == kFalseContact) continue;
      const ConflictTable* table = evidence_->conflicts(static_cast<int>(k), static_cast<int>(l));
      if (table == nullptr) continue;
      const int j = places_[l];
      const bool conflict = ((table->by_object[places_[k]][j / 64] >> (j % 64)) & 1U) != 0;
      if (conflict) conflicts += k == l ? 2 : 1;
    }
  }
  return parameters_->exponent * log_attraction - parameters_->conflict_cost * conflicts;
}

}  // namespace smore
