// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// Share of the samples in free space that may go unnoticed as such.
constexpr double kMissedFreeSpace = 0.01;

/// Share of the samples in free space from which the bias may not be learnt: where the bias is lost
/// to drift for want of them, it stays lost.
constexpr double kMissedDrift = 1e-4;

/// Random errors of a force/torque sensor, as its data sheet gives them.
struct SensorNoise {
  double force_stddev = 0.0;          ///< of one unfiltered sample, per axis [N]
  double torque_stddev = 0.0;         ///< of one unfiltered sample, per axis [N m]
  double force_drift = 0.0;           ///< random walk of the bias, per axis [N / sqrt(s)]
  double sample_period = 0.002;       ///< [s], positive; stamps may be off by half of it
  double filter_time_constant = 0.0;  ///< of the sensor's own low-pass, 1 / (2 pi cut-off) [s]
};

/// Probability that a vector of three independent standard normal components is longer than
/// `length` (the tail of Maxwell's distribution), docs/sensing.md (S1); 1 for a length that is not
/// positive.
double maxwellTail(double length);

/// The length with maxwellTail(length) = `probability`, in (0, 1].
double maxwellQuantile(double probability);

/// Least number of samples whose mean force errs by more than `error` [N, positive] with at most
/// `probability`: ceil((maxwellQuantile(probability) force_stddev / error)^2). 1 without noise, at
/// most a million.
int noiseSamples(const SensorNoise& noise, double error, double probability);

}  // namespace smore
