// SPDX-License-Identifier: BSD-3-Clause
// Replays recorded trials through the belief as it is now and writes proper scores of it as JSON.
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "smore/common/json_lines.h"
#include "smore/common/result.h"
#include "smore/common/version.h"
#include "smore/experiment/command_line.h"
#include "smore/experiment/output_file.h"
#include "smore/experiment/program_main.h"
#include "smore/experiment/score_report.h"
#include "smore/scenario/scenario_json.h"

namespace {

namespace po = boost::program_options;

constexpr const char* kEvidence = "evidence";

struct Arguments {
  std::vector<std::string> evidence;
  std::string method_parameters;
  std::string output;
  bool quick = false;
};

po::options_description optionsFor(Arguments* arguments) {
  po::options_description options("Proper scores of the belief on recorded trials");
  auto add = options.add_options();
  add(kEvidence, po::value(&arguments->evidence)->value_name("FILE")->required(),
      "files of smore_experiment --record; the option's name may be left out");
  add("parameters", po::value(&arguments->method_parameters)->value_name("FILE"),
      "file (YAML) that changes parameters of the belief");
  add("output", po::value(&arguments->output)->value_name("FILE"),
      "file (JSON) instead of standard output");
  add("quick", po::bool_switch(&arguments->quick),
      "a first look: fewer motions, seeds and shuffles");
  return options;
}

// Trials are put together by the scene's name: a copy of a scene that keeps its name is refused if
// its task differs. Of other solids a recorded task knows nothing.
void checkNames(const std::vector<smore::Evidence>& evidence) {
  std::map<std::string, const smore::Evidence*> first;
  for (const smore::Evidence& trial : evidence) {
    const smore::Evidence* other = first.emplace(trial.source.task.name, &trial).first->second;
    if (smore::toJson(trial.source.task) == smore::toJson(other->source.task)) continue;
    throw smore::InputError(other->file + " and " + trial.file + ": tasks that differ have the " +
                            "name " + trial.source.task.name +
                            "; score them one by one, or name their scenes differently");
  }
}

int run(const Arguments& arguments) {
  std::vector<std::string> inputs = arguments.evidence;
  inputs.push_back(arguments.method_parameters);
  const std::string problem =
      arguments.output.empty() ? "" : smore::problemOfFile(arguments.output, inputs);
  if (!problem.empty()) {
    std::cerr << problem << std::endl;
    return smore::kInternalError;
  }
  smore::MethodParameters parameters;
  if (!arguments.method_parameters.empty()) {
    parameters = smore::loadMethodParameters(arguments.method_parameters);
  }
  // All are read before the first is scored, which takes long.
  std::vector<smore::Evidence> evidence;
  std::vector<smore::TrialTruth> truths;
  for (const std::string& file : arguments.evidence) {
    evidence.push_back(smore::readEvidence(file, parameters));
    if (!evidence.back().whole) std::cerr << file << ": the last record was cut" << std::endl;
    truths.push_back(smore::readTruth(file));
  }
  checkNames(evidence);
  std::vector<smore::TrialScores> trials;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    std::cerr << arguments.evidence[i] << std::endl;
    trials.push_back(smore::scoreTrial(evidence[i], truths[i],
                                       arguments.quick ? smore::kQuickEffort : smore::kFullEffort));
  }
  const smore::Json json{{"program", std::string("smore ") + smore::programVersion()},
                         {"quick", arguments.quick},
                         {"files", arguments.evidence},
                         {"parameters", smore::toJson(smore::MethodKind::kSmore, parameters)},
                         {"groups", smore::scoreReport(trials)}};
  if (arguments.output.empty()) {
    std::cout << smore::textOf(json) << std::endl;
    return 0;
  }
  std::ofstream stream(arguments.output);
  stream << smore::textOf(json) << std::endl;
  if (!stream) {
    std::cout << smore::textOf(json) << std::endl;
    std::cerr << arguments.output
              << ": cannot be written; check the disk; the scores are on standard output"
              << std::endl;
    return smore::kInternalError;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  const auto options = optionsFor(&arguments);
  return smore::runProgram(
      argc, argv, options, [&] { return run(arguments); }, kEvidence);
}
