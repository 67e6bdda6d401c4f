// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "smore/common/json_lines.h"
#include "smore/experiment/experiment.h"

namespace smore {
namespace {

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json scoreJson(const MapScore& score, bool with_distances) {
  Json json{{"occupied", score.occupied},
            {"precision", orNull(score.precision)},
            {"recall", orNull(score.recall)}};
  if (with_distances) json["distances"] = score.distances;
  return json;
}

Json surfaceJson(const MapScore& score, const std::optional<double>& surface_recall) {
  Json json = scoreJson(score, false);
  json["surface_recall"] = orNull(surface_recall);
  return json;
}

Json touchesJson(const TouchScore& score) {
  return {{"touches", score.touches},
          {"reason", score.reason},
          {"object_map", surfaceJson(score.object_map, score.object_surface_recall)},
          {"world_map", surfaceJson(score.world_map, score.world_surface_recall)}};
}

Json motionsJson(const std::vector<PlannedMotion>& motions) {
  Json list = Json::array();
  for (const PlannedMotion& motion : motions) {
    list.push_back({{"risk", motion.risk}, {"touched", motion.touched}});
  }
  return list;
}

Json trialJson(const TrialResult& trial, bool with_distances) {
  Json json{{"seed", trial.seed},
            {"success", trial.success},
            {"broken", trial.broken},
            {"reason", trial.reason},
            {"collisions", trial.collisions},
            {"plans", trial.plans},
            {"path_length", trial.path_length},
            {"wall_s", trial.wall_s},
            {"planning_s", trial.planning_s},
            {"mapping_s", trial.mapping_s},
            {"simulation_s", trial.simulation_s},
            {"simulated_s", trial.simulated_s},
            {"motions", motionsJson(trial.motions)},
            {"object_map", scoreJson(trial.object_map, with_distances)},
            {"world_map", scoreJson(trial.world_map, with_distances)}};
  if (trial.after_touches) json["after_touches"] = touchesJson(*trial.after_touches);
  return json;
}

std::optional<double> meanOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> medianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::optional<double> sampleStddev(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double mean = *meanOf(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

Json summaryJson(const std::vector<TrialResult>& trials) {
  std::vector<double> collisions;
  std::vector<double> successes;
  for (const TrialResult& trial : trials) {
    if (!trial.broken) collisions.push_back(trial.collisions);
    successes.push_back(trial.success ? 1.0 : 0.0);
  }
  const auto [min, max] = std::minmax_element(collisions.begin(), collisions.end());
  const bool none = collisions.empty();
  return {{"success_rate", orNull(meanOf(successes))},
          {"collisions",
           {{"mean", orNull(meanOf(collisions))},
            {"median", orNull(medianOf(collisions))},
            {"min", none ? Json(nullptr) : Json(static_cast<int>(*min))},
            {"max", none ? Json(nullptr) : Json(static_cast<int>(*max))},
            {"stddev", orNull(sampleStddev(collisions))}}}};
}

}  // namespace

std::string toJson(const Scenario& scenario, const ExperimentParameters& parameters,
                   const std::vector<TrialResult>& trials) {
  const bool with_distances = scenario.task == Task::kReconstruct;
  Json list = Json::array();
  for (const TrialResult& trial : trials) list.push_back(trialJson(trial, with_distances));
  Json json{{"scenario", scenario.name},
            {"method", methodName(parameters.method)},
            {"seed", parameters.seed},
            {"trials", list},
            {"summary", summaryJson(trials)}};
  if (takesParameters(parameters.method)) {
    json["parameters"] = toJson(parameters.method, parameters.method_parameters);
  }
  return textOf(json);
}

}  // namespace smore
