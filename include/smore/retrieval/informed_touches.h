// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "smore/mapping/counter_random.h"
#include "smore/mapping/joint_belief.h"
#include "smore/retrieval/touch_planner.h"

namespace smore {

struct InformedTouchParameters {
  int probes = 300;  ///< motions among which the best is chosen, at least 1
  /// Of the part that may touch at least, and what a radian counts in it: half of a held thing's
  /// reach, in units of length of what is held. At most a probe is as long as the workspace:
  /// lengths are drawn log-uniform, so that what nobody has been near yet may tell most.
  double probe_length = 3.0;
  double lever = 3.0;
  double least_information = 0.1;  ///< below, nothing is left to tell [nat]
};

/// Motions whose outcome tells most about what the object and the world look like: along a way that
/// was free, then straight on where the sampled worlds disagree, near or far.
///
/// A sampled world says where on the probe the touch will be, or that there is none. The outcome is
/// then a function of the world, and what it tells about the worlds (the mutual information) is its
/// entropy. Matter that nothing has touched yet may end the probe too, with the rate of ContactRisk
/// and at any of the places of the object's surface that could be the first to touch it.
class InformedTouches : public TouchPlanner {
 public:
  /// `belief` is a view. Until there is a contact, motions are random.
  InformedTouches(const JointBelief& belief, const MotionSpace& space,
                  const InformedTouchParameters& parameters, std::uint64_t seed);

  Result<Path> nextTouch(const Pose& from) override;

  /// Entropy of the outcome of the last motion that was chosen [nat]; of the best one where it was
  /// not worth while.
  double information() const { return information_; }

 private:
  Pose drawEnd(const Pose& from, double held, CounterRandom* random) const;

  const JointBelief* belief_;
  MotionSpace space_;
  InformedTouchParameters parameters_;
  RandomTouches first_;
  CounterRandom random_;
  double information_ = 0.0;
};

}  // namespace smore
