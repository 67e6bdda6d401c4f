// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "smore/experiment/map_score.h"
#include "smore/retrieval/method.h"
#include "smore/retrieval/retrieval.h"
#include "smore/scenario/scenario.h"

namespace smore {

struct ExperimentParameters {
  MethodKind method = MethodKind::kSmore;
  MethodParameters method_parameters;  ///< of the method
  int trials = 1;                      ///< at least 1
  std::uint64_t seed = 1;              ///< trial i (from 1) uses seed + i - 1
  int jobs = 1;  ///< trials at a time, at least 1; the results do not depend on it
  int max_collisions = 2000;
  int touches_after_success = 0;      ///< further touches for the sake of the maps, not negative
  bool random_touches = false;        ///< touch at random, whatever the method knows better
  bool informed_touches = false;      ///< where they tell most, also in space; only with smore
  std::vector<Path> written_touches;  ///< these motions instead of the method's own; empty: its own
  std::string maps_directory;         ///< where each trial's maps are saved; empty: they are not
  std::string record_directory;       ///< where each trial's evidence is recorded; it exists
};

/// The maps after further touches.
struct TouchScore {
  int touches = 0;
  std::string reason;  ///< why it ended
  MapScore object_map;
  MapScore world_map;
  /// Share of the touchable surface that the maps know (surfaceRecall); nothing where none is.
  std::optional<double> object_surface_recall;
  std::optional<double> world_surface_recall;
};

struct TrialResult {
  std::uint64_t seed = 0;
  bool success = false;
  bool broken = false;  ///< an error ended it: the counts are those last told, the rest is void
  std::string reason;   ///< why it ended
  int collisions = 0;
  int plans = 0;
  double path_length = 0.0;  ///< executed in the last attempt [m]
  double wall_s = 0.0;
  double planning_s = 0.0;
  double mapping_s = 0.0;  ///< contact sensing included
  double simulation_s = 0.0;
  double simulated_s = 0.0;            ///< time that passed in the simulation
  std::vector<PlannedMotion> motions;  ///< of the task retrieve, in their order
  MapScore object_map;
  MapScore world_map;
  std::optional<TouchScore> after_touches;  ///< with touches_after_success only
};

/// What an experiment tells while it runs; called from the trials' threads, one at a time.
struct ExperimentProgress {
  std::uint64_t seed = 0;
  int collisions = 0;
  int plans = 0;
  bool finished = false;
  bool success = false;
  std::string reason;
};

using ExperimentCallback = std::function<void(const ExperimentProgress&)>;

/// Runs one trial. std::exception if the simulation fails or the maps cannot be written.
TrialResult runTrial(const Scenario& scenario, const ExperimentParameters& parameters,
                     std::uint64_t seed, const std::atomic<bool>& interrupted,
                     const ExperimentCallback& on_progress);

/// Runs all trials, in the order of their seeds in the result. When `interrupted` becomes true,
/// running trials end at their next motion and are left out. A trial that throws is `broken`.
std::vector<TrialResult> runExperiment(const Scenario& scenario,
                                       const ExperimentParameters& parameters,
                                       const std::atomic<bool>& interrupted,
                                       const ExperimentCallback& on_progress);

/// The result file's content (docs/experiments.md).
std::string toJson(const Scenario& scenario, const ExperimentParameters& parameters,
                   const std::vector<TrialResult>& trials);

}  // namespace smore
