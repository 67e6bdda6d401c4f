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
                             int place, float known_pull) {
  centers[contact] = places.at(place);
  normals[contact] = its_normals.at(place);
  sums[contact] = known_pull;
}

float GibbsChain::Side::between(int a, int b) const {
  return kernel(centers[a] - centers[b], normals[a], normals[b]);
}

GibbsChain::GibbsChain(const std::vector<ContactHypotheses>& contacts,
                       const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                       const DistributionParameters& parameters)
    : contacts_(&contacts),
      evidence_(&evidence),
      prior_(&prior),
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
  const auto known = [&](MapSide side) { return prior_->pull(side, contact, place, believed_); };
  object_.place(contact, touched.object, touched.object_normal, place, known(MapSide::kObject));
  world_.place(contact, touched.world, touched.world_normal, place, known(MapSide::kWorld));
  changeSums(contact, 1.0F);
}

void GibbsChain::believe(int piece, bool is_true) {
  const PriorMask bit = PriorMask{1} << piece;
  if (((believed_ & bit) != 0) == is_true) return;
  believed_ ^= bit;
  const MapSide side = prior_->known(piece).side();
  std::vector<float>& sums = (side == MapSide::kObject ? object_ : world_).sums;
  for (std::size_t k = 0; k < contacts_->size(); ++k) {
    if (places_[k] == kFalseContact) continue;
    const float pull = prior_->pull(side, static_cast<int>(k), places_[k], bit);
    sums[k] = std::max(0.0F, sums[k] + (is_true ? pull : -pull));
  }
}

double GibbsChain::bindingOf(int piece) const {
  const PriorMask bit = PriorMask{1} << piece;
  const MapSide side = prior_->known(piece).side();
  const Side& its = side == MapSide::kObject ? object_ : world_;
  int conflicts = prior_->conflictsOf(piece, believed_ & ~bit);
  double log_attraction = 0.0;
  for (std::size_t k = 0; k < contacts_->size(); ++k) {
    if (places_[k] == kFalseContact) continue;
    const int contact = static_cast<int>(k);
    conflicts += prior_->conflicts(contact, places_[k], bit);
    const double pull = prior_->pull(side, contact, places_[k], bit);
    const double others = std::max(0.0, its.sums[k] - ((believed_ & bit) != 0 ? pull : 0.0));
    log_attraction += std::log((its.base + others + pull) / (its.base + others));
  }
  return parameters_->exponent * log_attraction - parameters_->conflict_cost * conflicts;
}

int GibbsChain::priorConflicts() const {
  int conflicts = 0;
  for (int piece = 0; piece < prior_->count(); ++piece) {
    const PriorMask bit = PriorMask{1} << piece;
    if ((believed_ & bit) == 0) continue;
    conflicts += prior_->conflictsOf(piece, believed_ & (bit - 1));
    for (std::size_t k = 0; k < contacts_->size(); ++k) {
      if (places_[k] == kFalseContact) continue;
      conflicts += prior_->conflicts(static_cast<int>(k), places_[k], bit);
    }
  }
  return conflicts;
}

double GibbsChain::binding() const {
  double log_attraction = 0.0;
  const int conflicts = priorConflicts() + contradictions(places_, *evidence_);
  for (std::size_t k = 0; k < contacts_->size(); ++k) {
    if (places_[k] == kFalseContact) continue;
    log_attraction +=
        std::log1p(object_.sums[k] / object_.base) + std::log1p(world_.sums[k] / world_.base);
  }
  return parameters_->exponent * log_attraction - parameters_->conflict_cost * conflicts;
}

}  // namespace smore
