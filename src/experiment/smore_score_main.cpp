// SPDX-License-Identifier: BSD-3-Clause
// Replays recorded trials through the belief as it is now and writes proper scores of it as JSON.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "smore/common/result.h"
#include "smore/common/version.h"
#include "smore/experiment/output_paths.h"
#include "smore/experiment/score_report.h"

namespace {

constexpr int kInternalError = 1;
constexpr int kBadInput = 2;

struct Arguments {
  std::vector<std::string> evidence;
  std::string method_parameters;
  std::string output;
  bool quick = false;
};

void declare(CLI::App* app, Arguments* arguments) {
  app->add_option("evidence", arguments->evidence, "files of smore_experiment --record")
      ->required();
  app->add_option("--parameters", arguments->method_parameters,
                  "file (YAML) that changes parameters of the belief");
  app->add_option("--output", arguments->output, "file (JSON) instead of standard output");
  app->add_flag("--quick", arguments->quick, "a first look: fewer motions, seeds and shuffles");
}

int run(const Arguments& arguments) {
  const std::string problem =
      arguments.output.empty() ? "" : smore::problemOfFile(arguments.output);
  if (!problem.empty()) {
    std::cerr << problem << std::endl;
    return kInternalError;
  }
  smore::MethodParameters parameters;
  if (!arguments.method_parameters.empty()) {
    parameters = smore::loadMethodParameters(arguments.method_parameters);
  }
  std::vector<smore::TrialScores> trials;
  for (const std::string& file : arguments.evidence) {
    std::cerr << file << std::endl;
    trials.push_back(smore::scoreTrial(smore::readEvidence(file, parameters),
                                       smore::readTruth(file),
                                       arguments.quick ? smore::kQuickEffort : smore::kFullEffort));
  }
  const smore::Json json{{"program", std::string("smore ") + smore::programVersion()},
                         {"quick", arguments.quick},
                         {"files", arguments.evidence},
                         {"parameters", smore::toJson(parameters)},
                         {"groups", smore::scoreReport(trials)}};
  if (arguments.output.empty()) {
    std::cout << json.dump(2) << std::endl;
    return 0;
  }
  std::ofstream stream(arguments.output);
  stream << json.dump(2) << std::endl;
  if (!stream) {
    std::cerr << arguments.output << ": cannot be written; check the disk" << std::endl;
    return kInternalError;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Proper scores of the belief on recorded trials", "smore_score");
  declare(&app, &arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << error.what() << "; --help lists the options" << std::endl;
    return kBadInput;
  }
  try {
    return run(arguments);
  } catch (const smore::InputError& error) {
    std::cerr << error.what() << std::endl;
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << std::endl;
    return kInternalError;
  }
}
