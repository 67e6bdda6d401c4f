// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace smore {

/// Makes probabilities, of sum 1, of logarithms that are known up to one constant; at least one is
/// finite, and none is infinitely large.
template <std::size_t Count>
void exponentiate(std::array<double, Count>* logarithms) {
  const double largest = *std::max_element(logarithms->begin(), logarithms->end());
  double sum = 0.0;
  for (double& value : *logarithms) sum += value = std::exp(value - largest);
  for (double& value : *logarithms) value /= sum;
}

}  // namespace smore
