// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/tempered_population.h"

#include <algorithm>
#include <cmath>

#include "smore/common/parallel_for.h"
#include "smore/mapping/counter_random.h"

namespace smore {

TemperedPopulation::TemperedPopulation(const std::vector<ContactHypotheses>& contacts,
                                       const FreeSpaceEvidence& evidence,
                                       const DistributionParameters& parameters, int count,
                                       std::uint64_t seed)
    : parameters_(parameters),
      seed_(seed),
      chains_(count, GibbsChain(contacts, evidence, parameters)) {}

std::vector<Explanation> TemperedPopulation::run() {
  sweep(0.0, mixBits(seed_, 0));
  const double step = 1.0 / parameters_.temperatures;
  for (int t = 1; t <= parameters_.temperatures; ++t) {
    resample(step, mixBits(~seed_, t));
    sweep(t * step, mixBits(seed_, t));
  }
  for (int i = 1; i <= parameters_.sweeps; ++i) {
    sweep(1.0, mixBits(seed_, parameters_.temperatures + i));
  }
  std::vector<Explanation> explanations;
  for (const GibbsChain& chain : chains_) explanations.push_back(chain.explanation());
  return explanations;
}

void TemperedPopulation::sweep(double heat, std::uint64_t seed) {
  parallelFor(chains_.size(), [&](std::size_t m) { chains_[m].sweep(heat, mixBits(seed, m)); });
}

void TemperedPopulation::resample(double heat_step, std::uint64_t seed) {
  std::vector<double> weights;
  for (const GibbsChain& chain : chains_) weights.push_back(heat_step * chain.binding());
  const double largest = *std::max_element(weights.begin(), weights.end());
  double sum = 0.0;
  for (double& weight : weights) sum += weight = std::exp(weight - largest);
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
