// SPDX-License-Identifier: BSD-3-Clause
// Runs trials of a scenario in one process, without ROS, and writes their scores as JSON.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "smore/common/output_directory.h"
#include "smore/common/result.h"
#include "smore/experiment/command_line.h"
#include "smore/experiment/experiment.h"
#include "smore/experiment/in_process_robot.h"
#include "smore/experiment/output_file.h"
#include "smore/experiment/program_main.h"
#include "smore/experiment/progress_display.h"
#include "smore/mapping/prior_maps.h"
#include "smore/retrieval/written_touches.h"
#include "smore/scenario/scenario_files.h"
#include "smore/scenario/scenario_json.h"
#include "smore/simulation/simulated_robot.h"

namespace {

namespace po = boost::program_options;

constexpr int kInterrupted = 130;
constexpr int kMany = 1000000;

// The one thing that a signal handler may touch.
std::atomic<bool> interrupted{false};

void onInterrupt(int /*signal*/) { interrupted = true; }

struct Arguments {
  std::string scenario;
  std::string method = "smore";
  std::string method_parameters;
  std::string touch_poses;
  std::string output;
  bool validate = false;
  smore::ExperimentParameters parameters;
};

po::options_description optionsFor(Arguments* arguments) {
  smore::ExperimentParameters& parameters = arguments->parameters;
  po::options_description options(
      "Trials of simultaneous mapping and object reconstruction by touch");
  auto add = options.add_options();
  add("scenario", po::value(&arguments->scenario)->value_name("NAME_OR_FILE")->required(),
      "name in config/scenarios, or path of a file (YAML)");
  add("method", new smore::ChoiceOption(&arguments->method, smore::methodNames()),
      "how to map and plan");
  add("parameters", po::value(&arguments->method_parameters)->value_name("FILE"),
      "file (YAML) that changes parameters of the method");
  add("trials", new smore::NumberOption<int>(&parameters.trials, 1, kMany), "number of trials");
  add("seed", new smore::NumberOption<std::uint64_t>(&parameters.seed, 0, UINT64_MAX),
      "seed of the first trial");
  add("jobs", new smore::NumberOption<int>(&parameters.jobs, 1, 1024), "trials at a time");
  add("max-collisions", new smore::NumberOption<int>(&parameters.max_collisions, 1, kMany),
      "a trial gives up at so many");
  add("touches-after-success",
      new smore::NumberOption<int>(&parameters.touches_after_success, 0, kMany),
      "further touches for the maps once the object is out (their surface recall in planar motion "
      "only)");
  add("random-touches", po::bool_switch(&parameters.random_touches),
      "touch at random where the method would choose; for comparison");
  add("informed-touches", po::bool_switch(&parameters.informed_touches),
      "touch where most is told in space too, where touches are at random; for comparison");
  add("touch-poses", po::value(&arguments->touch_poses)->value_name("FILE"),
      "touch by the motions of a file (YAML) where the method would choose");
  add("output", po::value(&arguments->output)->value_name("FILE"),
      "result file (JSON) instead of standard output; with --validate, the scenario as read");
  add("maps", po::value(&parameters.maps_directory)->value_name("DIRECTORY"),
      "directory for each trial's octrees");
  add("record", po::value(&parameters.record_directory)->value_name("DIRECTORY"),
      "directory for each trial's evidence (seed_N.evidence)");
  add("validate", po::bool_switch(&arguments->validate), "only check the scenario");
  return options;
}

bool writeFile(const std::string& json, const std::string& file) {
  std::ofstream stream(file);
  stream << json << std::endl;
  stream.close();
  return stream.good();
}

// An output that cannot be written must be known before hours of trials, not after. `inputs` are
// the files that must stay.
bool canWriteOutputs(const Arguments& arguments, const std::vector<std::string>& inputs) {
  const std::string& maps = arguments.parameters.maps_directory;
  const std::string& records = arguments.parameters.record_directory;
  std::string problem;
  if (!arguments.output.empty()) problem = smore::problemOfFile(arguments.output, inputs);
  if (problem.empty() && !maps.empty()) problem = smore::problemOfMapsDirectory(maps, inputs);
  if (problem.empty() && !records.empty()) problem = smore::problemOfDirectory(records);
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
  return smore::kInternalError;
}

std::vector<std::string> inputsOf(const Arguments& arguments, const std::string& scenario_file,
                                  const smore::Scenario& scenario) {
  std::vector<std::string> inputs = smore::filesOf(scenario);
  inputs.insert(inputs.end(), {scenario_file, arguments.method_parameters, arguments.touch_poses});
  return inputs;
}

// At most one way to touch that is not the method's own, and only where there are touches for the
// maps.
void checkTouches(const Arguments& arguments, smore::Task task) {
  const smore::ExperimentParameters& parameters = arguments.parameters;
  if (parameters.informed_touches && arguments.method != "smore") {
    throw smore::InputError("--informed-touches: only the method smore can choose them");
  }
  const int ways = (parameters.random_touches ? 1 : 0) + (parameters.informed_touches ? 1 : 0) +
                   (arguments.touch_poses.empty() ? 0 : 1);
  if (ways > 1) {
    throw smore::InputError(
        "--random-touches, --informed-touches, --touch-poses: give one of them");
  }
  if (ways == 1 && task == smore::Task::kRetrieve && parameters.touches_after_success == 0) {
    throw smore::InputError(
        "--random-touches, --informed-touches, --touch-poses: a retrieval touches for the maps "
        "only after it; give --touches-after-success, or a scenario with the task reconstruct");
  }
}

// Refuses what cannot be simulated.
void checkSimulation(const smore::Scenario& scenario, std::uint64_t seed) {
  const auto robot = smore::makeSimulatedRobot(scenario, seed);
  robot->advance();
  smore::requireNoFaultAtStart(*robot);
}

int run(Arguments arguments) {
  arguments.parameters.method = smore::methodKind(arguments.method);
  if (!arguments.method_parameters.empty()) {
    smore::checkTakesParameters(arguments.parameters.method);
  }
  const std::string file =
      smore::findScenario(arguments.scenario, smore::shippedScenarioDirectory());
  const smore::Scenario scenario = smore::loadScenario(file);
  checkTouches(arguments, scenario.task);
  if (!arguments.method_parameters.empty()) {
    arguments.parameters.method_parameters =
        smore::loadMethodParameters(arguments.method_parameters);
  }
  if (!arguments.touch_poses.empty()) {
    arguments.parameters.written_touches =
        smore::loadMotions(arguments.touch_poses, scenario.motionSpace());
  }
  const bool for_real_robots = arguments.validate && !scenario.hasScene();
  if (!for_real_robots) checkSimulation(scenario, arguments.parameters.seed);
  smore::checkPriors(arguments.parameters.method, smore::makePriors(scenario));
  if (!canWriteOutputs(arguments, inputsOf(arguments, file, scenario))) {
    return smore::kInternalError;
  }
  if (arguments.validate) {
    const bool told =
        arguments.output.empty() || writeFile(smore::toJson(scenario), arguments.output);
    if (!told)
      std::cerr << arguments.output << ": cannot be written; check its directory" << std::endl;
    std::cerr << file << ": valid" << (for_real_robots ? ", a task for a real robot" : "")
              << decompositions(scenario) << std::endl;
    return told ? 0 : smore::kInternalError;
  }
  // From here on there are trials to be finished and written; before, a signal ends the program.
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  if (std::signal(SIGHUP, onInterrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
  std::signal(SIGPIPE, SIG_IGN);  // whoever looks on may go; the results are worth hours
  smore::ProgressDisplay display(&std::cerr, isatty(STDERR_FILENO) != 0,
                                 arguments.parameters.trials);
  const auto trials =
      smore::runExperiment(scenario, arguments.parameters, interrupted,
                           [&display](const auto& progress) { display.update(progress); });
  if (interrupted && trials.empty()) return kInterrupted;  // an earlier file stays
  const std::string json = smore::toJson(scenario, arguments.parameters, trials);
  return write(json, arguments.output) ? exitCode(trials) : smore::kInternalError;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  const auto options = optionsFor(&arguments);
  return smore::runProgram(argc, argv, options, [&] { return run(std::move(arguments)); });
}
