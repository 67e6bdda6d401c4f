// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/gibbs_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

#include "smore/common/wide_vectors.h"
#include "smore/mapping/bit_counts.h"
#include "smore/mapping/counter_random.h"

namespace smore {
namespace {

constexpr std::int16_t kNoRow = -1;

constexpr float kLog2 = 0.693147181F;

// Places in a row that are looked at together.
constexpr int kStride = 16;

// Each factor of a product of 1 + kernel / (base + sum) is at most 1 + 1 / base: with so many of
// them it stays far from the largest float.
int factorsPerLog(double base) {
  constexpr double kLargestLog = 80.0;
  return std::max(1, static_cast<int>(kLargestLog / std::log1p(1.0 / base)));
}

bool areZero(const float* kernels) {
  std::array<std::uint32_t, kStride> bits;  // integers, since their sums may be taken in any order
  std::memcpy(bits.data(), kernels, sizeof(bits));
  std::uint32_t any = 0;
  for (const std::uint32_t of_one : bits) any |= of_one;
  return any == 0;
}

}  // namespace

GibbsSweep::GibbsSweep(const std::vector<ContactHypotheses>& contacts,
                       const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                       const DistributionParameters& parameters, std::vector<SweptChain> chains,
                       double heat)
    : contacts_(contacts),
      evidence_(evidence),
      prior_(prior),
      parameters_(parameters),
      chains_(std::move(chains)),
      heat_(heat),
      exponent_(static_cast<float>(heat * parameters.exponent)),
      cost_(static_cast<float>(heat * parameters.conflict_cost)),
      attractions_(chains_.size()),
      rows_(chains_.size()) {
  row_of_place_.fill(kNoRow);
}

void GibbsSweep::run(const std::vector<int>& order) {
  for (const int contact : order) visit(contact);
  for (int piece = 0; piece < prior_.count(); ++piece) {
    for (const SweptChain& swept : chains_) judge(piece, swept);
  }
}

void GibbsSweep::judge(int piece, const SweptChain& swept) const {
  const KnownMatter& known = prior_.known(piece);
  const double log_odds = known.logOdds() + heat_ * swept.chain->bindingOf(piece);
  const double probability = 1.0 / (1.0 + std::exp(-log_odds));
  CounterRandom random(mixBits(known.id(), ~swept.seed));
  swept.chain->believe(piece, random.uniform() < probability);
}

void GibbsSweep::visit(int contact) {
  const ContactHypotheses& touched = contacts_[contact];
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    chains_[c].chain->remove(contact);
    attractions_[c].factor.fill(1.0F);
    attractions_[c].exponent.fill(0);
  }
  if (exponent_ > 0.0F) {
    attract(contact, MapSide::kObject, touched.object, touched.object_normal);
    attract(contact, MapSide::kWorld, touched.world, touched.world_normal);
  }
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    chains_[c].chain->add(contact, draw(contact, chains_[c], attractions_[c]));
  }
}

void GibbsSweep::attract(int contact, MapSide side, const PointArray& places,
                         const PointArray& normals) {
  if (chains_.empty()) return;
  const SideOf side_of = side == MapSide::kObject ? &GibbsChain::object : &GibbsChain::world;
  const int count = contacts_[contact].count;
  const float base = (chains_.front().chain->*side_of)().base;
  const int most_factors = factorsPerLog(base);
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    attractions_[c].sum.fill(0.0F);
    prior_.addPulls(side, contact, chains_[c].chain->believed(), attractions_[c].sum.data());
  }
  int factors = 0;
  for (std::size_t other = 0; other < contacts_.size(); ++other) {
    if (static_cast<int>(other) == contact) continue;
    attractTo(contact, static_cast<int>(other), side_of, places, normals);
    if (++factors < most_factors) continue;
    for (Attraction& attraction : attractions_) keepMantissas(&attraction);
    factors = 0;
  }
  for (Attraction& attraction : attractions_) {
    keepMantissas(&attraction);
    for (int i = 0; i < count; ++i) attraction.factor[i] *= 1.0F + attraction.sum[i] / base;
    keepMantissas(&attraction);
  }
}

void GibbsSweep::attractTo(int contact, int other, SideOf side_of, const PointArray& places,
                           const PointArray& normals) {
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const GibbsChain& chain = *chains_[c].chain;
    const int place = chain.explanation()[other];
    if (place == kFalseContact) continue;
    const GibbsChain::Side& side = (chain.*side_of)();
    const KernelRow& row = rowOf(place, side, other, contacts_[contact].count, places, normals);
    multiply(row, 1.0F / (side.base + side.sums[other]), &attractions_[c]);
  }
  for (std::size_t row = 0; row < known_rows_; ++row) row_of_place_[rows_[row].place] = kNoRow;
  known_rows_ = 0;
}

const GibbsSweep::KernelRow& GibbsSweep::rowOf(int place, const GibbsChain::Side& side, int other,
                                               int count, const PointArray& places,
                                               const PointArray& normals) {
  std::int16_t& row = row_of_place_[place];
  if (row == kNoRow) {
    row = static_cast<std::int16_t>(known_rows_++);
    rows_[row].place = place;
    fillRow(side, other, count, places, normals, &rows_[row]);
  }
  return rows_[row];
}

SMORE_WIDE_VECTORS void GibbsSweep::fillRow(const GibbsChain::Side& side, int other, int count,
                                            const PointArray& places, const PointArray& normals,
                                            KernelRow* row) {
  const AttractionKernel attraction = side.kernel;
  const Eigen::Vector3f touch = side.centers[other];
  const Eigen::Vector3f normal = side.normals[other];
  const int end = (count + kStride - 1) / kStride * kStride;
  row->first = end;
  row->last = 0;
  for (int i = 0; i < end; ++i) {
    const float dx = places.x[i] - touch.x();
    const float dy = places.y[i] - touch.y();
    const float dz = places.z[i] - touch.z();
    const float a = normal.x() * dx + normal.y() * dy + normal.z() * dz;
    const float b = normals.x[i] * dx + normals.y[i] * dy + normals.z[i] * dz;
    row->kernels[i] = attraction.of(dx * dx + dy * dy + dz * dz, a * a + b * b);
  }
  for (int begin = 0; begin < end; begin += kStride) {
    if (areZero(&row->kernels[begin])) continue;
    row->first = std::min(row->first, begin);
    row->last = begin + kStride;
  }
}

SMORE_WIDE_VECTORS void GibbsSweep::multiply(const KernelRow& row, float gain,
                                             Attraction* attraction) {
  for (int i = row.first; i < row.last; ++i) {
    attraction->sum[i] += row.kernels[i];
    attraction->factor[i] *= 1.0F + row.kernels[i] * gain;
  }
}

// A float of at least 1 is its mantissa, from 1 to 2, and its exponent: that of a product is moved
// to where it cannot grow too large.
SMORE_WIDE_VECTORS void GibbsSweep::keepMantissas(Attraction* attraction) {
  constexpr std::uint32_t kMantissa = 0x7FFFFF;
  constexpr std::uint32_t kOne = 0x3F800000;
  constexpr int kExponent = 23;  // its lowest bit
  std::array<std::uint32_t, kCandidates> bits;
  std::memcpy(bits.data(), attraction->factor.data(), sizeof(bits));
  for (int i = 0; i < kCandidates; ++i) {
    attraction->exponent[i] += static_cast<std::int32_t>((bits[i] - kOne) >> kExponent);
    bits[i] = (bits[i] & kMantissa) | kOne;
  }
  std::memcpy(attraction->factor.data(), bits.data(), sizeof(bits));
}

int GibbsSweep::draw(int contact, const SweptChain& swept, const Attraction& attraction) const {
  const ContactHypotheses& touched = contacts_[contact];
  const int count = touched.count;
  Row conflicts{};
  countConflicts(contact, *swept.chain, &conflicts);
  Row weight;
  Eigen::Map<Eigen::ArrayXf>(weight.data(), count) =
      Eigen::Map<const Eigen::ArrayXf>(attraction.factor.data(), count).log();
  for (int i = 0; i < count; ++i) {
    const float log = weight[i] + kLog2 * static_cast<float>(attraction.exponent[i]);
    weight[i] = touched.log_prior[i] + exponent_ * log - cost_ * conflicts[i];
  }
  const auto nothing = static_cast<float>(std::log(parameters_.false_contact) -
                                          std::log1p(-parameters_.false_contact));
  const float largest =
      std::max(nothing, *std::max_element(weight.begin(), weight.begin() + count));
  float sum = std::exp(nothing - largest);
  const float nothing_weight = sum;
  for (int i = 0; i < count; ++i) sum += weight[i] = std::exp(weight[i] - largest);
  CounterRandom random(mixBits(touched.id, ~swept.seed));
  float left = static_cast<float>(random.uniform()) * sum - nothing_weight;
  if (left < 0.0F) return kFalseContact;
  int place = 0;
  for (; place + 1 < count; ++place) {
    left -= weight[place];
    if (left < 0.0F) break;
  }
  return place;
}

SMORE_WIDE_VECTORS void GibbsSweep::countConflicts(int contact, const GibbsChain& chain,
                                                   Row* conflicts) const {
  // The rows lie far apart in memory: all are asked for before the first is needed.
  std::vector<const CandidateBits*> rows;
  rows.reserve(2 * contacts_.size());
  const auto take = [&rows](const CandidateBits& row) {
    __builtin_prefetch(&row);
    rows.push_back(&row);
  };
  for (std::size_t l = 0; l < contacts_.size(); ++l) {
    const int place = chain.explanation()[l];
    if (place == kFalseContact || static_cast<int>(l) == contact) continue;
    const int other = static_cast<int>(l);
    const ConflictTable* on_object = evidence_.conflicts(contact, other);
    const ConflictTable* in_world = evidence_.conflicts(other, contact);
    if (on_object != nullptr) take(on_object->by_world[place]);
    if (in_world != nullptr) take(in_world->by_object[place]);
  }
  BitCounts<std::tuple_size<CandidateBits>::value> counts;
  for (const CandidateBits* row : rows) {
    std::uint64_t any = 0;
    for (const std::uint64_t word : *row) any |= word;
    if (any != 0) counts.add(*row);
  }
  const int count = contacts_[contact].count;
  const auto counted = counts.counts();
  std::copy(counted.begin(), counted.begin() + count, conflicts->begin());
  prior_.addConflicts(contact, chain.believed(), conflicts->data());
  const ConflictTable* own = evidence_.conflicts(contact, contact);
  if (own == nullptr) return;
  for (int i = 0; i < count; ++i) {
    if (((own->by_object[i][i / 64] >> (i % 64)) & 1U) != 0) (*conflicts)[i] += 2.0F;
  }
}

}  // namespace smore
