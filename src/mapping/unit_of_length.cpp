// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/unit_of_length.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "smore/mapping/log_probabilities.h"

namespace smore {
namespace {

constexpr double kSmallestUnit = 0.002;  // [m]
constexpr double kRatio = 1.5;

// Chosen with the probability below on tuning seeds of fourteen scenes, for the least bias between
// motion in a plane and in space.
constexpr double kFreedom = 4.0;

// Probability that a contact says nothing of the unit: it is head on, or with something of another
// size. Its offset is then log-uniform over the range of the units.
constexpr double kSaysNothing = 0.2;

// Units that half of the distances between touches are below, chosen like the freedom.
constexpr double kTouchesApart = 2.0;

// As many contacts say as much of the size of a held thing as its known surface does: a choice, for
// a step or two of the units before anything is touched.
constexpr double kKnownSurface = 4.0;

// Probability that the levers mislead, as those of a long tool that touches thin things: each unit
// is then so much less likely than the next one nearer to theirs. Choices: rare, and not by much.
constexpr double kMisled = 0.05;
constexpr double kFarther = 0.3;

// What the right unit may cost [nats]: less than one contradiction.
constexpr double kBearable = 3.0;

// No offset is known better [m]: half the smallest unit.
constexpr double kLeastOffset = 0.5 * kSmallestUnit;

// Student's t over the distance from its centre, in one dimension or two.
double density(double distance, double scale, int dimensions) {
  const double ratio = distance / scale;
  const double falling = std::pow(1.0 + ratio * ratio / kFreedom, -0.5 * (kFreedom + dimensions));
  if (dimensions == 2) return 2.0 * M_PI * distance * falling / (2.0 * M_PI * scale * scale);
  const double norm = std::tgamma(0.5 * (kFreedom + 1.0)) /
                      (std::tgamma(0.5 * kFreedom) * std::sqrt(kFreedom * M_PI));
  return 2.0 * norm * falling / scale;
}

double likelihood(const LeverOfContact& lever, double unit, int dimensions) {
  const double offset = std::max(lever.offset, kLeastOffset);
  const double range = (kUnits - 1) * std::log(kRatio);
  return (1.0 - kSaysNothing) * density(offset, std::hypot(unit, lever.offset_stddev), dimensions) +
         kSaysNothing / (range * std::max(offset, lever.offset_stddev));
}

// Of the distances between all touches, as if there were one less than there are touches.
double logLikelihoodOfDistances(const std::vector<LeverOfContact>& contacts, double unit) {
  const double scale = kTouchesApart * unit;
  double sum = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (contacts[i].origin - contacts[j].origin).norm();
      sum += std::log(scale) - 2.0 * std::log(scale + distance);
    }
  }
  return contacts.empty() ? 0.0 : 2.0 / static_cast<double>(contacts.size()) * sum;
}

// The units of the levers, and others beside them.
std::array<double, kUnits> widened(const std::array<double, kUnits>& by_levers) {
  const double beside = kMisled * (1.0 - kFarther) / (1.0 + kFarther);
  std::array<double, kUnits> result{};
  for (int i = 0; i < kUnits; ++i) {
    result[i] = (1.0 - kMisled) * by_levers[i];
    for (int j = 0; j < kUnits; ++j) {
      result[i] += by_levers[j] * beside * std::pow(kFarther, std::abs(i - j));
    }
  }
  return result;
}

// Log likelihood of the contacts at a unit, but for a constant.
double valueOf(const UnitEvidence& evidence) {
  return evidence.agreement - std::max(0.0, evidence.cost - kBearable);
}

using EvidenceOfUnits = std::map<int, UnitEvidence>;

bool isBearable(const std::pair<const int, UnitEvidence>& of_unit) {
  return of_unit.second.cost <= kBearable;
}

// Of the units that are likely by their levers and, where none of them is bearable, of smaller ones
// as long as they are better: too small a one cannot reach what a larger one explains. Few touches
// agree by chance: that they do counts where it leads to smaller units.
EvidenceOfUnits evidenceOfUnits(const std::array<double, kUnits>& by_levers, int strata,
                                const std::function<UnitEvidence(int)>& evidence) {
  const std::array<int, kUnits> likely = worldsOfUnits(by_levers, strata, strata);
  EvidenceOfUnits result;
  for (int i = 0; i < kUnits; ++i) {
    if (likely[i] > 0) result[i] = evidence(i);
  }
  const int smallest = result.begin()->first;
  int best = smallest;
  bool explained = std::any_of(result.begin(), result.end(), isBearable);
  for (int i = smallest - 1; i >= 0 && !explained; --i) {
    result[i] = evidence(i);
    if (valueOf(result[i]) <= valueOf(result[best])) break;
    best = i;
    explained = result[best].cost <= kBearable;
  }
  if (best == smallest) {
    for (auto& [index, of_unit] : result) of_unit.agreement = 0.0;
  }
  return result;
}

// At the nearest unit whose evidence is known.
double valueAt(int index, const EvidenceOfUnits& known) {
  const auto nearest =
      std::min_element(known.begin(), known.end(), [index](const auto& a, const auto& b) {
        return std::abs(a.first - index) < std::abs(b.first - index);
      });
  return valueOf(nearest->second);
}

}  // namespace

double unitOfLength(int index) { return kSmallestUnit * std::pow(kRatio, index); }

std::array<double, kUnits> unitProbabilities(const std::vector<LeverOfContact>& levers, bool planar,
                                             const std::vector<LeverOfContact>& known) {
  const int dimensions = planar ? 1 : 2;
  std::array<double, kUnits> result{};
  for (int i = 0; i < kUnits; ++i) {
    result[i] = logLikelihoodOfDistances(levers, unitOfLength(i));
    for (const LeverOfContact& lever : levers) {
      result[i] += std::log(likelihood(lever, unitOfLength(i), dimensions));
    }
    for (const LeverOfContact& lever : known) {
      result[i] += kKnownSurface / static_cast<double>(known.size()) *
                   std::log(likelihood(lever, unitOfLength(i), dimensions));
    }
  }
  exponentiate(&result);
  return result;
}

// docs/belief.md (U1).
std::array<double, kUnits> probabilitiesByEvidence(
    const std::array<double, kUnits>& by_levers, int strata,
    const std::function<UnitEvidence(int index)>& evidence) {
  const EvidenceOfUnits known = evidenceOfUnits(by_levers, strata, evidence);
  if (std::all_of(known.begin(), known.end(), isBearable)) return by_levers;
  std::array<double, kUnits> result = widened(by_levers);
  for (int i = 0; i < kUnits; ++i) result[i] = std::log(result[i]) + valueAt(i, known);
  exponentiate(&result);
  return result;
}

std::array<int, kUnits> worldsOfUnits(const std::array<double, kUnits>& probabilities, int total,
                                      int strata) {
  std::array<int, kUnits> result{};
  double passed = 0.0;
  int stratum = 0;
  for (int i = 0; i < kUnits; ++i) {
    passed += probabilities[i];
    for (; stratum < strata && (stratum + 0.5) / strata < passed; ++stratum) {
      result[i] += total * (stratum + 1) / strata - total * stratum / strata;
    }
  }
  return result;
}

}  // namespace smore
