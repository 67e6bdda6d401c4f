// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/gibbs_chain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "smore/mapping/bit_counts.h"
#include "smore/mapping/counter_random.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SMORE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define SMORE_WIDE_VECTORS
#endif

namespace smore {
namespace {

// Each factor of the products below is at most 1 + 1 / base, so that so many of them stay far from
// the largest float for any base above 0.01.
constexpr int kFactorsPerLog = 12;

}  // namespace

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

void GibbsChain::sweep(double heat, std::uint64_t seed) {
  for (const int contact : visitOrder(seed)) {
    remove(contact);
    add(contact, draw(contact, heat, seed));
  }
}

std::vector<int> GibbsChain::visitOrder(std::uint64_t seed) const {
  std::vector<std::pair<std::uint64_t, int>> keyed;
  for (std::size_t k = 0; k < contacts_->size(); ++k) {
    keyed.emplace_back(mixBits((*contacts_)[k].id, seed), static_cast<int>(k));
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<int> order;
  order.reserve(keyed.size());
  for (const auto& entry : keyed) order.push_back(entry.second);
  return order;
}

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

int GibbsChain::draw(int contact, double heat, std::uint64_t seed) const {
  const int count = (*contacts_)[contact].count;
  Row weight;
  logWeights(contact, heat, &weight);
  const float nothing = static_cast<float>(std::log(parameters_->false_contact) -
                                           std::log1p(-parameters_->false_contact));
  const float largest =
      std::max(nothing, *std::max_element(weight.begin(), weight.begin() + count));
  float sum = std::exp(nothing - largest);
  const float nothing_weight = sum;
  for (int i = 0; i < count; ++i) sum += weight[i] = std::exp(weight[i] - largest);
  CounterRandom random(mixBits((*contacts_)[contact].id, ~seed));
  float left = static_cast<float>(random.uniform()) * sum - nothing_weight;
  if (left < 0.0F) return kFalseContact;
  int place = 0;
  for (; place + 1 < count; ++place) {
    left -= weight[place];
    if (left < 0.0F) break;
  }
  return place;
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

void GibbsChain::logWeights(int contact, double heat, Row* log_weight) const {
  Row attraction{};
  Row conflicts{};
  const ContactHypotheses& touched = (*contacts_)[contact];
  addAttraction(contact, object_, touched.object, touched.object_normal, &attraction);
  addAttraction(contact, world_, touched.world, touched.world_normal, &attraction);
  countConflicts(contact, &conflicts);
  const auto exponent = static_cast<float>(heat * parameters_->exponent);
  const auto cost = static_cast<float>(heat * parameters_->conflict_cost);
  for (int i = 0; i < (*contacts_)[contact].count; ++i) {
    (*log_weight)[i] =
        (*contacts_)[contact].log_prior[i] + exponent * attraction[i] - cost * conflicts[i];
  }
}

// The innermost loop of all: wider vectors where the processor has them. They round alike, since
// multiplications and additions stay apart.
SMORE_WIDE_VECTORS void GibbsChain::addAttraction(int contact, const Side& side,
                                                  const PointArray& places,
                                                  const PointArray& normals,
                                                  Row* log_weight) const {
  const int count = (*contacts_)[contact].count;
  const AttractionKernel attraction = side.kernel;
  Row sum{};
  Row factor;
  factor.fill(1.0F);
  int factors = 0;
  const auto flush = [&] {
    for (int i = 0; i < count; ++i) (*log_weight)[i] += std::log(factor[i]);
    factor.fill(1.0F);
    factors = 0;
  };
  for (std::size_t l = 0; l < contacts_->size(); ++l) {
    if (places_[l] == kFalseContact || static_cast<int>(l) == contact) continue;
    const float gain = 1.0F / (side.base + side.sums[l]);
    const Eigen::Vector3f& other = side.centers[l];
    const Eigen::Vector3f& normal = side.normals[l];
    for (int i = 0; i < count; ++i) {
      const float dx = places.x[i] - other.x();
      const float dy = places.y[i] - other.y();
      const float dz = places.z[i] - other.z();
      const float a = normal.x() * dx + normal.y() * dy + normal.z() * dz;
      const float b = normals.x[i] * dx + normals.y[i] * dy + normals.z[i] * dz;
      const float kernel = attraction.of(dx * dx + dy * dy + dz * dz, a * a + b * b);
      sum[i] += kernel;
      factor[i] *= 1.0F + kernel * gain;
    }
    if (++factors == kFactorsPerLog) flush();
  }
  for (int i = 0; i < count; ++i) factor[i] *= 1.0F + sum[i] / side.base;
  flush();
}

SMORE_WIDE_VECTORS void GibbsChain::countConflicts(int contact, Row* conflicts) const {
  // The rows lie far apart in memory: all are asked for before the first is needed.
  std::vector<const CandidateBits*> rows;
  rows.reserve(2 * contacts_->size());
  const auto take = [&rows](const CandidateBits& row) {
    __builtin_prefetch(&row);
    rows.push_back(&row);
  };
  for (std::size_t l = 0; l < contacts_->size(); ++l) {
    if (places_[l] == kFalseContact || static_cast<int>(l) == contact) continue;
    const int other = static_cast<int>(l);
    const ConflictTable* on_object = evidence_->conflicts(contact, other);
    const ConflictTable* in_world = evidence_->conflicts(other, contact);
    if (on_object != nullptr) take(on_object->by_world[places_[l]]);
    if (in_world != nullptr) take(in_world->by_object[places_[l]]);
  }
  BitCounts<std::tuple_size<CandidateBits>::value> counts;
  for (const CandidateBits* row : rows) counts.add(*row);
  const int count = (*contacts_)[contact].count;
  for (int i = 0; i < count; ++i) (*conflicts)[i] = static_cast<float>(counts.of(i));
  const ConflictTable* own = evidence_->conflicts(contact, contact);
  if (own == nullptr) return;
  for (int i = 0; i < count; ++i) {
    if (((own->by_object[i][i / 64] >> (i % 64)) & 1U) != 0) (*conflicts)[i] += 2.0F;
  }
}

}  // namespace smore
