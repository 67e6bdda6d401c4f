// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// experiment: many trials in one process, their records and their scores.

#include <optional>
#include <string>
#include <vector>

#include "smore/experiment/effective_worlds.h"
#include "smore/experiment/proper_scores.h"
#include "smore/experiment/trial_truth.h"
#include "smore/experiment/voxel_reliability.h"
#include "smore/retrieval/evidence.h"

namespace smore {

/// How much is computed.
struct ScoreEffort {
  int most_motions;  ///< of a trial before which the belief is asked, evenly spaced, the last one
                     ///< too
  int seeds;         ///< with which the worlds are drawn for their effective number, at least 2
  int moments;       ///< of a trial at which they are: before motions, evenly spaced, the last too
  int shuffles;      ///< of a trial's observations
};

/// What is reported, and less for a first look.
constexpr ScoreEffort kFullEffort{1000000, 16, 3, 5};
constexpr ScoreEffort kQuickEffort{6, 4, 2, 1};

/// What the belief said of where a motion would touch first.
struct TouchForecast {
  double log_probability = 0.0;  ///< of what came of it [nat]
  std::optional<int> leg;        ///< on which it touched; nothing: nowhere
};

/// What a belief says along one recorded trial, beside what came about (docs/scoring.md).
struct TrialScores {
  std::string scene;
  Motion motion = Motion::kPlanar;
  int worlds = 0;                      ///< that the belief draws
  std::vector<Forecast> risks;         ///< of planned motions, each by the evidence before it
  std::vector<TouchForecast> touches;  ///< of the same motions
  /// Log densities of the true places: before each motion the mean over the contacts so far, and of
  /// each contact by all evidence.
  std::vector<double> places_before;
  std::vector<double> places_after;
  int contacts_of_many_places = 0;  ///< which have no true place
  std::vector<Forecast> object_voxels;
  std::vector<Forecast> world_voxels;
  std::vector<SeedScatter> scatter;  ///< at each moment, of the motions from then on
  /// Share of the worlds in which the motion that reached the goal touches, before each motion
  /// from the first contact on.
  std::vector<double> way_out;
  MapDifference order;
};

/// Replays a trial through a belief. InputError where the evidence does not fit.
TrialScores scoreTrial(const Evidence& evidence, const TrialTruth& truth,
                       const ScoreEffort& effort);

}  // namespace smore
