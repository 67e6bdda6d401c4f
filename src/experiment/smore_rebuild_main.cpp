// SPDX-License-Identifier: BSD-3-Clause
// Makes the maps of recorded evidence anew, the same ones or with another method or parameters.
#include <iostream>

#include "program_main.h"
#include "smore/common/result.h"
#include "smore/experiment/command_line.h"
#include "smore/experiment/output_paths.h"
#include "smore/experiment/rebuild.h"

namespace {

namespace po = boost::program_options;

struct Arguments {
  std::string evidence;
  std::string method;
  std::string method_parameters;
  double voxel_size = 0.0;
  std::string output;
};

po::options_description optionsFor(Arguments* arguments) {
  po::options_description options("Makes the maps of recorded evidence");
  auto add = options.add_options();
  add("evidence", po::value(&arguments->evidence)->value_name("FILE")->required(),
      "file of smore_experiment --record");
  add("method", new smore::ChoiceOption(&arguments->method, smore::methodNames()),
      "instead of the recorded one");
  add("parameters", po::value(&arguments->method_parameters)->value_name("FILE"),
      "file (YAML) with parameters of the method smore instead of the recorded ones");
  add("voxel-size", new smore::NumberOption<double>(&arguments->voxel_size, 1e-3, 1.0),
      "of the maps [m], instead of the recorded");
  add("output", po::value(&arguments->output)->value_name("DIRECTORY")->required(),
      "directory for the maps and summary.json");
  return options;
}

int run(const Arguments& arguments) {
  std::optional<smore::MethodParameters> parameters;
  if (!arguments.method_parameters.empty()) {
    parameters = smore::loadMethodParameters(arguments.method_parameters);
  }
  smore::Evidence evidence = smore::readEvidence(arguments.evidence, parameters);
  smore::RebuildChanges changes;
  if (!arguments.method.empty()) changes.method = smore::methodKind(arguments.method);
  if (arguments.voxel_size > 0.0) changes.voxel_size = arguments.voxel_size;
  if (parameters && changes.method.value_or(evidence.source.method) != smore::MethodKind::kSmore) {
    throw smore::InputError("--parameters: only the method smore takes them");
  }
  const std::string problem = smore::problemOfDirectory(arguments.output);
  if (!problem.empty()) {
    std::cerr << problem << std::endl;
    return smore::kInternalError;
  }
  if (!evidence.whole) {
    std::cerr << arguments.evidence << ": the last record was cut; the maps are of "
              << evidence.observations.size() << " whole observations" << std::endl;
  }
  smore::rebuild(std::move(evidence), changes, arguments.output);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  const auto options = optionsFor(&arguments);
  return smore::runProgram(argc, argv, options, [&] { return run(arguments); });
}
