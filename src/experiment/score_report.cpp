// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/score_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "smore/experiment/first_touch.h"

namespace smore {
namespace {

// Bins with fewer voxels say too little.
constexpr int kLeastVoxels = 200;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json meanJson(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Json binsJson(const std::vector<ReliabilityBin>& bins) {
  Json list = Json::array();
  for (const ReliabilityBin& bin : bins) {
    if (bin.count == 0) continue;
    list.push_back({{"from", bin.low},
                    {"to", bin.high},
                    {"count", bin.count},
                    {"stated", bin.stated},
                    {"true", bin.happened}});
  }
  return list;
}

Json riskJson(const std::vector<Forecast>& risks) {
  const auto bins = reliability(risks, tenths());
  const auto touched = std::count_if(risks.begin(), risks.end(),
                                     [](const Forecast& forecast) { return forecast.happened; });
  return {{"motions", risks.size()},
          {"touched", touched},
          {"log_loss", orNull(logLoss(risks))},
          {"constant_log_loss", orNull(constantLogLoss(risks))},
          {"auc", orNull(areaUnderCurve(risks))},
          {"calibration_error", orNull(calibrationError(bins))},
          {"bins", binsJson(bins)}};
}

// Beside one who knows the share of the other motions that touched.
Json firstTouchJson(const std::vector<TouchForecast>& touches) {
  const auto touched =
      std::count_if(touches.begin(), touches.end(),
                    [](const TouchForecast& forecast) { return forecast.leg.has_value(); });
  std::vector<double> logs;
  std::vector<double> uniform;
  for (const TouchForecast& touch : touches) {
    logs.push_back(touch.log_probability);
    const auto others = static_cast<double>(touched - (touch.leg ? 1 : 0));
    uniform.push_back(
        logUniformTouch((others + 0.5) / static_cast<double>(touches.size()), touch.leg));
  }
  return {{"legs", kLegs}, {"log_score", meanJson(logs)}, {"uniform_log_score", meanJson(uniform)}};
}

Json voxelsJson(const std::vector<Forecast>& voxels) {
  const auto bins = reliability(voxels, voxelBins());
  return {{"voxels", voxels.size()},
          {"calibration_error", orNull(calibrationError(bins))},
          {"largest_error", orNull(largestError(bins, kLeastVoxels))},
          {"bins", binsJson(bins)}};
}

template <typename T>
void append(const std::vector<T>& part, std::vector<T>* whole) {
  whole->insert(whole->end(), part.begin(), part.end());
}

void add(const TrialScores& trial, TrialScores* sum) {
  sum->worlds = trial.worlds;
  append(trial.risks, &sum->risks);
  append(trial.touches, &sum->touches);
  append(trial.places_before, &sum->places_before);
  append(trial.places_after, &sum->places_after);
  sum->contacts_of_many_places += trial.contacts_of_many_places;
  append(trial.object_voxels, &sum->object_voxels);
  append(trial.world_voxels, &sum->world_voxels);
  sum->scatter.resize(trial.scatter.size());
  for (std::size_t i = 0; i < trial.scatter.size(); ++i) sum->scatter[i] += trial.scatter[i];
  append(trial.way_out, &sum->way_out);
  sum->order.largest = std::max(sum->order.largest, trial.order.largest);
  sum->order.sum += trial.order.sum;
  sum->order.voxels += trial.order.voxels;
}

Json orderJson(const MapDifference& order) {
  if (order.voxels == 0) return nullptr;
  return {{"largest", order.largest}, {"mean", order.sum / order.voxels}};
}

Json effectiveJson(const std::vector<SeedScatter>& scatter) {
  Json list = Json::array();
  for (const SeedScatter& at_moment : scatter) list.push_back(orNull(effectiveWorlds(at_moment)));
  return list;
}

Json groupJson(const std::string& name, const std::vector<const TrialScores*>& trials) {
  TrialScores sum;
  for (const TrialScores* trial : trials) add(*trial, &sum);
  return {{"group", name},
          {"trials", trials.size()},
          {"risk", riskJson(sum.risks)},
          {"first_touch", firstTouchJson(sum.touches)},
          {"places",
           {{"log_score_before_motions", meanJson(sum.places_before)},
            {"log_score_at_the_end", meanJson(sum.places_after)},
            {"contacts", sum.places_after.size()},
            {"contacts_of_many_places", sum.contacts_of_many_places}}},
          {"world_voxels", voxelsJson(sum.world_voxels)},
          {"object_voxels", voxelsJson(sum.object_voxels)},
          {"worlds", {{"drawn", sum.worlds}, {"effective", effectiveJson(sum.scatter)}}},
          {"way_out", {{"moments", sum.way_out.size()}, {"touching", meanJson(sum.way_out)}}},
          {"order", orderJson(sum.order)}};
}

template <typename Belongs>
std::vector<const TrialScores*> those(const std::vector<TrialScores>& trials, Belongs belongs) {
  std::vector<const TrialScores*> group;
  for (const TrialScores& trial : trials) {
    if (belongs(trial)) group.push_back(&trial);
  }
  return group;
}

}  // namespace

Json scoreReport(const std::vector<TrialScores>& trials) {
  std::vector<std::string> scenes;
  for (const TrialScores& trial : trials) {
    if (std::find(scenes.begin(), scenes.end(), trial.scene) == scenes.end()) {
      scenes.push_back(trial.scene);
    }
  }
  Json groups = Json::array();
  for (const std::string& scene : scenes) {
    groups.push_back(groupJson(
        scene, those(trials, [&](const TrialScores& trial) { return trial.scene == scene; })));
  }
  for (const Motion motion : {Motion::kPlanar, Motion::kSpatial}) {
    const auto group =
        those(trials, [&](const TrialScores& trial) { return trial.motion == motion; });
    const char* name = motion == Motion::kPlanar ? "all in the plane" : "all in space";
    if (!group.empty()) groups.push_back(groupJson(name, group));
  }
  return groups;
}

}  // namespace smore
