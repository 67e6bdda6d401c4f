// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/tempered_population.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "smore/common/parallel_for.h"
#include "smore/mapping/counter_random.h"
#include "smore/mapping/gibbs_sweep.h"

namespace smore {
namespace {

// Steps of the temperature are halved down to this part of the longest.
constexpr double kShortestStep = 1.0 / 4.0;

constexpr double kRounding = 1e-9;  // of the sum of all steps

// The largest is 1.
std::vector<double> weightsOf(const std::vector<double>& bindings, double heat_step) {
  const double largest = *std::max_element(bindings.begin(), bindings.end());
  std::vector<double> weights;
  weights.reserve(bindings.size());
  for (const double binding : bindings)
    weights.push_back(std::exp(heat_step * (binding - largest)));
  return weights;
}

// Effective sample size over the number of samples (Kong et al. 1994).
double effectiveShare(const std::vector<double>& weights) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double weight : weights) {
    sum += weight;
    squares += weight * weight;
  }
  return sum * sum / (squares * static_cast<double>(weights.size()));
}

}  // namespace

TemperedPopulation::TemperedPopulation(const std::vector<ContactHypotheses>& contacts,
                                       const FreeSpaceEvidence& evidence,
                                       const PriorEvidence& prior,
                                       const DistributionParameters& parameters, int count,
                                       std::uint64_t seed)
    : contacts_(contacts),
      evidence_(evidence),
      prior_(prior),
      parameters_(parameters),
      seed_(seed),
      chains_(count, GibbsChain(contacts, evidence, prior, parameters)) {}

std::vector<JointSample> TemperedPopulation::run() {
  sweep(0.0, mixBits(seed_, 0));
  std::uint64_t sweeps = 0;
  for (double heat = 0.0; heat < 1.0;) {
    const std::vector<double> bindings = bindingOfChains();
    const double left = 1.0 - heat;
    const double step = nextStep(bindings, left);
    heat = step < left ? heat + step : 1.0;
    resample(weightsOf(bindings, step), mixBits(~seed_, ++sweeps));
    sweep(heat, mixBits(seed_, sweeps));
  }
  for (int i = 0; i < parameters_.sweeps; ++i) sweep(1.0, mixBits(seed_, ++sweeps));
  std::vector<JointSample> samples;
  for (const GibbsChain& chain : chains_) {
    samples.push_back({chain.explanation(), chain.believed()});
  }
  return samples;
}

void TemperedPopulation::sweep(double heat, std::uint64_t seed) {
  const std::vector<int> order = visitOrder(seed);
  const std::vector<std::size_t> alike = chainsByExplanation();
  const std::size_t groups = std::min(chains_.size(), coreCount());
  parallelFor(groups, [&](std::size_t group) {
    std::vector<SweptChain> swept;
    const std::size_t end = (group + 1) * alike.size() / groups;
    for (std::size_t i = group * alike.size() / groups; i < end; ++i) {
      swept.push_back({&chains_[alike[i]], mixBits(seed, alike[i])});
    }
    GibbsSweep(contacts_, evidence_, prior_, parameters_, std::move(swept), heat).run(order);
  });
}

// Those that go on from one chain share what a sweep works out.
std::vector<std::size_t> TemperedPopulation::chainsByExplanation() const {
  std::vector<std::size_t> chains(chains_.size());
  std::iota(chains.begin(), chains.end(), 0);
  std::stable_sort(chains.begin(), chains.end(), [this](std::size_t a, std::size_t b) {
    return chains_[a].explanation() < chains_[b].explanation();
  });
  return chains;
}

std::vector<int> TemperedPopulation::visitOrder(std::uint64_t seed) const {
  std::vector<std::pair<std::uint64_t, int>> keyed;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    keyed.emplace_back(mixBits(contacts_[k].id, seed), static_cast<int>(k));
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<int> order;
  order.reserve(keyed.size());
  for (const auto& entry : keyed) order.push_back(entry.second);
  return order;
}

std::vector<double> TemperedPopulation::bindingOfChains() const {
  std::vector<double> bindings(chains_.size());
  parallelFor(chains_.size(), [&](std::size_t m) { bindings[m] = chains_[m].binding(); });
  return bindings;
}

double TemperedPopulation::nextStep(const std::vector<double>& bindings, double left) const {
  const double longest = 1.0 / parameters_.temperatures;
  double step = left <= longest * (1.0 + kRounding) ? left : longest;
  while (step > kShortestStep * longest &&
         effectiveShare(weightsOf(bindings, step)) < parameters_.least_share) {
    step *= 0.5;
  }
  return step;
}

void TemperedPopulation::resample(const std::vector<double>& weights, std::uint64_t seed) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  // Systematic: each chain is continued as often as its weight says, up to rounding.
  const double stride = sum / static_cast<double>(chains_.size());
  double at = CounterRandom(seed).uniform() * stride;
  std::vector<int> copies(chains_.size(), 0);
  double passed = 0.0;
  for (std::size_t m = 0; m < chains_.size(); ++m) {
    passed += weights[m];
    for (; at < passed; at += stride) ++copies[m];
  }
  continueChains(std::move(copies));
}

void TemperedPopulation::continueChains(std::vector<int> copies) {
  std::size_t source = 0;
  for (std::size_t m = 0; m < chains_.size(); ++m) {
    if (copies[m] > 0) continue;
    while (source < chains_.size() && copies[source] < 2) ++source;
    if (source == chains_.size()) return;
    chains_[m] = chains_[source];
    --copies[source];
  }
}

}  // namespace smore
