// SPDX-License-Identifier: BSD-3-Clause
// Time of one plan over the joint samples once 60 contacts are known.
#include <benchmark/benchmark.h>

#include "smore/experiment/in_process_robot.h"
#include "smore/mapping/joint_belief.h"
#include "smore/retrieval/method.h"
#include "smore/retrieval/reconstruction.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

constexpr int kContacts = 60;
constexpr std::uint64_t kSeed = 101;

// The method smore after contacts at random in a scenario's scene.
Method afterRandomTouches(const Scenario& scenario) {
  Method method = makeMethod(MethodKind::kSmore, scenario, kSeed);
  const auto simulated = makeSimulatedRobot(scenario, kSeed);
  InProcessRobot robot(simulated.get(), ContactSensingParameters{}, kSeed,
                       [&method](const ContactObservation& seen) { method.observe(seen); });
  RandomTouches touches(scenario.motionSpace(), kSeed);
  ReconstructionParameters parameters = reconstructionParameters(scenario);
  parameters.touches = kContacts;
  reconstruct(parameters, &robot, &touches, {}, {});
  return method;
}

void plan(benchmark::State& state, const char* scenario_name) {
  const Scenario scenario =
      loadScenario(std::string(SMORE_SOURCE_DIR) + "/config/scenarios/" + scenario_name + ".yaml");
  const Method method = afterRandomTouches(scenario);
  method.planner->plan(scenario.start, scenario.goal);  // the belief infers at its first use
  for (auto _ : state) {
    benchmark::DoNotOptimize(method.planner->plan(scenario.start, scenario.goal));
  }
}

BENCHMARK_CAPTURE(plan, planar, "s_shape_two_pegs")->Unit(benchmark::kMillisecond)->Iterations(10);
BENCHMARK_CAPTURE(plan, spatial, "slit")->Unit(benchmark::kMillisecond)->Iterations(10);

}  // namespace
}  // namespace smore
