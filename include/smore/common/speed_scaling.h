// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// The share of full speed, 0 to 1, at which a robot runs what it is commanded: that of the slider
/// on its pendant. A robot slower than this is paused.
constexpr double kLeastScaling = 0.01;

}  // namespace smore
