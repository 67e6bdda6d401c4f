// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/experiment.h"

#include <exception>
#include <mutex>
#include <thread>

#include "smore/common/elapsed_time.h"
#include "smore/experiment/in_process_robot.h"
#include "smore/experiment/map_files.h"
#include "smore/experiment/touchable_surface.h"
#include "smore/experiment/trial_recording.h"
#include "smore/mapping/prior_maps.h"
#include "smore/retrieval/reconstruction.h"
#include "smore/retrieval/retrieval.h"
#include "smore/retrieval/written_touches.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

RetrievalOutcome runTask(const Scenario& scenario, const ExperimentParameters& parameters,
                         Robot* robot, const Method& method, const std::atomic<bool>& interrupted,
                         const Retrieval::ProgressCallback& on_progress, MotionObserver* motions) {
  if (scenario.task == Task::kReconstruct) {
    ReconstructionParameters reconstruction = reconstructionParameters(scenario);
    reconstruction.max_collisions = parameters.max_collisions;
    return reconstruct(
        reconstruction, robot, method.touches.get(), on_progress,
        [&interrupted] { return interrupted.load(); }, motions);
  }
  RetrievalParameters retrieval_parameters = retrievalParameters(scenario);
  retrieval_parameters.max_collisions = parameters.max_collisions;
  Retrieval* running = nullptr;
  Retrieval retrieval(
      retrieval_parameters, robot, method.planner.get(),
      [&](const RetrievalProgress& progress) {
        if (interrupted) running->requestStop();
        on_progress(progress);
      },
      motions);
  running = &retrieval;
  return retrieval.run();
}

TouchScore touchFurther(const Scenario& scene, int touches, Robot* robot, const Method& method,
                        const std::atomic<bool>& interrupted, MotionObserver* motions) {
  ReconstructionParameters parameters = reconstructionParameters(scene);
  parameters.touches = touches;
  const RetrievalOutcome outcome = reconstruct(
      parameters, robot, method.touches.get(), {}, [&interrupted] { return interrupted.load(); },
      motions);
  const TouchableSurface surface = touchableSurface(scene);
  TouchScore score;
  score.touches = outcome.collisions;
  score.reason = outcome.reason;
  score.object_map = scoreObjectMap(method.maps->object(), scene);
  score.world_map = scoreWorldMap(method.maps->world(), scene);
  score.object_surface_recall = surfaceRecall(method.maps->object(), surface.object);
  score.world_surface_recall = surfaceRecall(method.maps->world(), surface.world);
  return score;
}

TrialResult resultOf(const RetrievalOutcome& outcome, const Scenario& scene, const Method& method,
                     const InProcessRobot& robot) {
  TrialResult result;
  result.success = outcome.success;
  result.reason = outcome.reason;
  result.collisions = outcome.collisions;
  result.plans = outcome.plans;
  result.path_length = outcome.path_length;
  result.planning_s = outcome.planning_s;
  result.motions = outcome.motions;
  result.mapping_s = robot.times().sensing_and_mapping;
  result.simulation_s = robot.times().simulation;
  result.object_map = scoreObjectMap(method.maps->object(), scene);
  result.world_map = scoreWorldMap(method.maps->world(), scene);
  return result;
}

std::unique_ptr<TrialRecording> startRecording(const Scenario& scenario,
                                               const ExperimentParameters& parameters,
                                               std::uint64_t seed, const Scenario& scene,
                                               const Priors& priors,
                                               const SimulatedRobot& simulated) {
  if (parameters.record_directory.empty()) return nullptr;
  return std::make_unique<TrialRecording>(
      evidenceFile(parameters.record_directory, seed),
      EvidenceSource{scenario, parameters.method, parameters.method_parameters, seed, priors},
      scene, &simulated);
}

void saveTrialMaps(const TwinMap& maps, const ExperimentParameters& parameters,
                   std::uint64_t seed) {
  const bool several = parameters.trials > 1;
  saveMaps(maps, parameters.maps_directory + (several ? "/seed_" + std::to_string(seed) : ""));
}

// Touches that are not the method's own; null where none are asked for.
std::unique_ptr<TouchPlanner> askedTouches(const ExperimentParameters& parameters,
                                           const Method& method, const Scenario& scenario,
                                           std::uint64_t seed) {
  if (parameters.random_touches) {
    return std::make_unique<RandomTouches>(scenario.motionSpace(), seed);
  }
  if (parameters.informed_touches) return makeInformedTouches(method, scenario, seed);
  if (parameters.written_touches.empty()) return nullptr;
  return std::make_unique<WrittenTouches>(parameters.written_touches);
}

}  // namespace

TrialResult runTrial(const Scenario& scenario, const ExperimentParameters& parameters,
                     std::uint64_t seed, const std::atomic<bool>& interrupted,
                     const ExperimentCallback& on_progress) {
  const auto begin = SteadyClock::now();
  const Scenario scene = perturbScenario(scenario, seed);
  const auto simulated = makeSimulatedRobot(scene, seed);
  const Priors priors = makePriors(scene);
  Method method =
      makeMethod(parameters.method, scenario, seed, parameters.method_parameters, priors);
  if (auto asked = askedTouches(parameters, method, scenario, seed)) {
    method.touches = std::move(asked);
  }
  const auto recording = startRecording(scenario, parameters, seed, scene, priors, *simulated);
  InProcessRobot robot(simulated.get(), sensingParameters(scene, *simulated), seed,
                       [&](const ContactObservation& observation) {
                         if (recording) recording->observe(observation);
                         method.observe(observation);
                       });

  ExperimentProgress news;
  news.seed = seed;
  double updating_s = 0.0;  // of the maps, before each plan
  const auto tell = [&](const RetrievalProgress& progress) {
    if (progress.phase == Phase::kPlanning) {
      const auto since = SteadyClock::now();
      method.maps->update();
      updating_s += secondsSince(since);
    }
    news.collisions = progress.collisions;
    news.plans = progress.plans;
    if (progress.phase != Phase::kFinished) on_progress(news);
  };
  const RetrievalOutcome outcome =
      runTask(scene, parameters, &robot, method, interrupted, tell, recording.get());
  TrialResult result = resultOf(outcome, scene, method, robot);
  result.seed = seed;
  result.mapping_s += updating_s;
  result.simulated_s = simulated->time();
  if (parameters.touches_after_success > 0 && result.success && !interrupted) {
    result.after_touches = touchFurther(scene, parameters.touches_after_success, &robot, method,
                                        interrupted, recording.get());
  }
  if (recording && !interrupted) recording->finish(outcome);
  if (!parameters.maps_directory.empty() && !interrupted) {
    saveTrialMaps(*method.maps, parameters, seed);
  }
  result.wall_s = secondsSince(begin);

  news.finished = true;
  news.success = result.success;
  news.reason = result.reason;
  on_progress(news);
  return result;
}

namespace {

// A trial that breaks costs no other one.
TrialResult runGuarded(const Scenario& scenario, const ExperimentParameters& parameters,
                       std::uint64_t seed, const std::atomic<bool>& interrupted,
                       const ExperimentCallback& on_progress) {
  ExperimentProgress last;
  last.seed = seed;
  const auto remember = [&](const ExperimentProgress& progress) {
    last = progress;
    on_progress(progress);
  };
  try {
    return runTrial(scenario, parameters, seed, interrupted, remember);
  } catch (const std::exception& error) {
    last.finished = true;
    last.success = false;
    last.reason = std::string("broken off: ") + error.what();
    on_progress(last);
  }
  TrialResult result;
  result.seed = seed;
  result.broken = true;
  result.reason = last.reason;
  result.collisions = last.collisions;
  result.plans = last.plans;
  return result;
}

}  // namespace

std::vector<TrialResult> runExperiment(const Scenario& scenario,
                                       const ExperimentParameters& parameters,
                                       const std::atomic<bool>& interrupted,
                                       const ExperimentCallback& on_progress) {
  std::vector<std::optional<TrialResult>> results(parameters.trials);
  std::atomic<int> next{0};
  std::mutex mutex;
  const auto report = [&](const ExperimentProgress& progress) {
    const std::lock_guard<std::mutex> lock(mutex);
    on_progress(progress);
  };
  const auto work = [&] {
    for (int i = next++; i < parameters.trials && !interrupted; i = next++) {
      TrialResult result =
          runGuarded(scenario, parameters, parameters.seed + i, interrupted, report);
      const bool is_whole = !interrupted || (result.success && !result.after_touches);
      if (is_whole) results[i] = std::move(result);
    }
  };
  std::vector<std::thread> threads;
  const int jobs = std::min(parameters.jobs, parameters.trials);
  threads.reserve(jobs);
  for (int i = 0; i < jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();

  std::vector<TrialResult> finished;
  for (auto& result : results) {
    if (result) finished.push_back(std::move(*result));
  }
  return finished;
}

}  // namespace smore
