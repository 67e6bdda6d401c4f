// SPDX-License-Identifier: BSD-3-Clause
// Runs trials of a scenario in one process, without ROS, and writes their scores as JSON.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "smore/common/result.h"
#include "smore/experiment/experiment.h"
#include "smore/experiment/output_paths.h"
#include "smore/experiment/progress_display.h"
#include "smore/scenario/scenario_files.h"
#include "smore/scenario/scenario_json.h"
#include "smore/simulation/simulated_robot.h"

namespace {

constexpr int kInternalError = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 130;

// The one thing that a signal handler may touch.
std::atomic<bool> interrupted{false};

void onInterrupt(int /*signal*/) { interrupted = true; }

struct Arguments {
  std::string scenario;
  std::string method = "smore";
  std::string method_parameters;
  std::string output;
  bool validate = false;
  smore::ExperimentParameters parameters;
};

void declare(CLI::App* app, Arguments* arguments) {
  smore::ExperimentParameters& parameters = arguments->parameters;
  const auto count = CLI::Range(1, 1000000);
  app->add_option("--scenario", arguments->scenario,
                  "name in config/scenarios, or path of a file (YAML)")
      ->required();
  app->add_option("--method", arguments->method, "how to map and plan")
      ->check(CLI::IsMember({"paper", "cspace", "smore"}))
      ->capture_default_str();
  app->add_option("--parameters", arguments->method_parameters,
                  "file (YAML) that changes parameters of the method smore");
  app->add_option("--trials", parameters.trials, "number of trials")
      ->check(count)
      ->capture_default_str();
  app->add_option("--seed", parameters.seed, "seed of the first trial")->capture_default_str();
  app->add_option("--jobs", parameters.jobs, "trials at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app->add_option("--max-collisions", parameters.max_collisions, "a trial gives up at so many")
      ->check(count)
      ->capture_default_str();
  app->add_option("--touches-after-success", parameters.touches_after_success,
                  "further touches for the maps once the object is out (planar motion only)")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  app->add_flag("--random-touches", parameters.random_touches,
                "touch at random where the method would choose; for comparison");
  app->add_option(
      "--output", arguments->output,
      "result file (JSON) instead of standard output; with --validate, the scenario as read");
  app->add_option("--maps", parameters.maps_directory, "directory for each trial's octrees");
  app->add_option("--record", parameters.record_directory,
                  "directory for each trial's evidence (seed_N.evidence)");
  app->add_flag("--validate", arguments->validate, "only check the scenario");
}

bool writeFile(const std::string& json, const std::string& file) {
  std::ofstream stream(file);
  stream << json << std::endl;
  stream.close();
  return stream.good();
}

// An output that cannot be written must be known before hours of trials, not after.
bool canWriteOutputs(const Arguments& arguments) {
  std::string problem;
  if (!arguments.output.empty()) problem = smore::problemOfFile(arguments.output);
  for (const std::string& directory :
       {arguments.parameters.maps_directory, arguments.parameters.record_directory}) {
    if (problem.empty() && !directory.empty()) problem = smore::problemOfDirectory(directory);
  }
  if (!problem.empty()) std::cerr << problem << std::endl;
  return problem.empty();
}

// True if the results have been written whole where they should. They are worth hours: where a file
// fails at the end, they go to standard output.
bool write(const std::string& json, const std::string& file) {
  if (!file.empty() && writeFile(json, file)) return true;
  std::cout << json << std::endl;
  if (file.empty() && std::cout.good()) return true;
  std::cerr << (file.empty() ? "standard output" : file) << ": cannot be written; check the disk"
            << (file.empty() ? "" : "; the results are on standard output") << std::endl;
  return false;
}

// What meshes of the object became that do not move as one convex solid.
std::string decompositions(const smore::Scenario& scenario) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  for (const smore::Shape& shape : scenario.object) {
    const auto* mesh = std::get_if<smore::MeshShape>(&shape.geometry);
    if (mesh == nullptr || mesh->parts.empty()) continue;
    text << "; " << mesh->file << " moves as " << mesh->parts.size()
         << " convex parts, whose surface is up to " << 1000.0 * mesh->parts_error << " mm off";
  }
  return text.str();
}

// The errors of broken trials are in the results; the exit code tells of them.
int exitCode(const std::vector<smore::TrialResult>& trials) {
  if (interrupted) return kInterrupted;
  const auto broken =
      std::count_if(trials.begin(), trials.end(), [](const auto& trial) { return trial.broken; });
  if (broken == 0) return 0;
  std::cerr << broken << " of " << trials.size() << " trials broke off; their reasons stand in "
            << "the results" << std::endl;
  return kInternalError;
}

int run(Arguments arguments) {
  const std::string file =
      smore::findScenario(arguments.scenario, smore::shippedScenarioDirectory());
  const smore::Scenario scenario = smore::loadScenario(file);
  if (!arguments.method_parameters.empty()) {
    arguments.parameters.method_parameters =
        smore::loadMethodParameters(arguments.method_parameters);
  }
  const bool for_real_robots = arguments.validate && !scenario.hasScene();
  if (!for_real_robots) {
    (void)smore::makeSimulatedRobot(scenario, arguments.parameters.seed);  // refuses what cannot be
  }
  if (arguments.validate) {
    const bool told =
        arguments.output.empty() || writeFile(smore::toJson(scenario), arguments.output);
    if (!told) std::cerr << arguments.output << ": cannot be written" << std::endl;
    std::cerr << file << ": valid" << (for_real_robots ? ", a task for a real robot" : "")
              << decompositions(scenario) << std::endl;
    return told ? 0 : kInternalError;
  }
  if (!canWriteOutputs(arguments)) return kInternalError;
  smore::ProgressDisplay display(&std::cerr, isatty(STDERR_FILENO) != 0,
                                 arguments.parameters.trials);
  const auto trials =
      smore::runExperiment(scenario, arguments.parameters, interrupted,
                           [&display](const auto& progress) { display.update(progress); });
  const std::string json = smore::toJson(scenario, arguments.parameters, trials);
  return write(json, arguments.output) ? exitCode(trials) : kInternalError;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Trials of simultaneous mapping and object reconstruction by touch",
               "smore_experiment");
  declare(&app, &arguments);
  try {
    app.parse(argc, argv);
    arguments.parameters.method = smore::methodKind(arguments.method);
    if (!arguments.method_parameters.empty() && arguments.method != "smore") {
      throw CLI::ValidationError("--parameters", "only the method smore takes them");
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << error.what() << "; --help lists the options" << std::endl;
    return kBadInput;
  }
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    return run(std::move(arguments));
  } catch (const smore::InputError& error) {
    std::cerr << error.what() << std::endl;
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << std::endl;
    return kInternalError;
  }
}
