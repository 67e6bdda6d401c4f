// SPDX-License-Identifier: BSD-3-Clause
// Plans, and how likely they are to touch: before anything was felt, and after each touch of a
// simulated robot that follows them.
#include <smore/experiment/in_process_robot.h>
#include <smore/retrieval/method.h>
#include <smore/scenario/scenario_files.h>
#include <smore/simulation/simulated_robot.h>

#include <iostream>

int main(int argc, char** argv) {
  const smore::Scenario scenario = smore::loadScenario(
      smore::findScenario(argc > 1 ? argv[1] : "one_peg", smore::shippedScenarioDirectory()));
  const std::uint64_t seed = 1;
  smore::Method method = smore::makeMethod(smore::MethodKind::kSmore, scenario, seed);
  const auto simulated = smore::makeSimulatedRobot(scenario, seed);
  smore::InProcessRobot robot(
      simulated.get(), {}, seed,
      [&](const smore::ContactObservation& observation) { method.observe(observation); });

  for (int touches = 0; touches < 40; ++touches) {
    const auto plan = method.planner->plan(robot.pose(), scenario.goal);
    if (!plan) {
      std::cerr << plan.reason() << "\n";
      return 1;
    }
    std::cout << touches << " touches: a way of " << smore::pathLength(plan->path)
              << " m, which touches with probability " << plan->risk << "\n";
    const smore::MotionResult motion = robot.follow(plan->path);
    if (motion.end == smore::MotionEnd::kReached) {
      std::cout << "the object is at the goal\n";
      return 0;
    }
    robot.reset(scenario.start);
  }
  return 1;
}
