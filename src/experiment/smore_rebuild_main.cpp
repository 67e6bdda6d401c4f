// SPDX-License-Identifier: BSD-3-Clause
// Makes the maps of recorded evidence anew, the same ones or with another method or parameters.
#include <CLI/CLI.hpp>
#include <iostream>

#include "smore/common/result.h"
#include "smore/experiment/output_paths.h"
#include "smore/experiment/rebuild.h"

namespace {

constexpr int kInternalError = 1;
constexpr int kBadInput = 2;

struct Arguments {
  std::string evidence;
  std::string method;
  std::string method_parameters;
  double voxel_size = 0.0;
  std::string output;
};

void declare(CLI::App* app, Arguments* arguments) {
  app->add_option("--evidence", arguments->evidence, "file of smore_experiment --record")
      ->required();
  app->add_option("--method", arguments->method, "instead of the recorded one")
      ->check(CLI::IsMember(smore::methodNames()));
  app->add_option("--parameters", arguments->method_parameters,
                  "file (YAML) with parameters of the method smore instead of the recorded ones");
  app->add_option("--voxel-size", arguments->voxel_size, "of the maps [m], instead of the recorded")
      ->check(CLI::Range(1e-3, 1.0));
  app->add_option("--output", arguments->output, "directory for the maps and summary.json")
      ->required();
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
    return kInternalError;
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
  CLI::App app("Makes the maps of recorded evidence", "smore_rebuild");
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
