// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_sizes.h"

#include <cmath>

#include "smore/mapping/mask_bricks.h"

namespace smore {

double sizeOfHypothesis(int hypothesis, double shortest, double longest) {
  return shortest * std::pow(longest / shortest, (hypothesis + 0.5) / kHypotheses);
}

}  // namespace smore
