// SPDX-License-Identifier: BSD-3-Clause
// Makes the maps of recorded evidence or of a bag anew, the same ones or with another method or
// parameters.
#include <ros/time.h>

#include <iostream>

#include "bag_evidence.h"
#include "other_task.h"
#include "smore/common/result.h"
#include "smore/experiment/command_line.h"
#include "smore/experiment/output_file.h"
#include "smore/experiment/program_main.h"
#include "smore/experiment/rebuild.h"

namespace {

namespace po = boost::program_options;

struct Arguments {
  std::string evidence;
  std::string bag;
  std::string scenario;
  std::string method;
  std::string method_parameters;
  double voxel_size = 0.0;
  std::string output;
};

po::options_description optionsFor(Arguments* arguments) {
  po::options_description options("Makes the maps of recorded evidence");
  auto add = options.add_options();
  add("evidence", po::value(&arguments->evidence)->value_name("FILE"),
      "file of smore_experiment --record, of a journal, or that was saved");
  add("bag", po::value(&arguments->bag)->value_name("FILE"),
      "bag with wrenches and transforms, instead");
  add("scenario", po::value(&arguments->scenario)->value_name("NAME|FILE"),
      "task, instead of the recorded one");
  add("method", new smore::ChoiceOption(&arguments->method, smore::methodNames()),
      "instead of the recorded one");
  add("parameters", po::value(&arguments->method_parameters)->value_name("FILE"),
      "file (YAML) with parameters of the method instead of the recorded ones");
  add("voxel-size", new smore::NumberOption<double>(&arguments->voxel_size, 1e-3, 1.0),
      "of the maps [m], instead of the recorded");
  add("output", po::value(&arguments->output)->value_name("DIRECTORY")->required(),
      "directory for the maps and summary.json");
  return options;
}

smore::Evidence fromBag(const Arguments& arguments,
                        const std::optional<smore::MethodParameters>& parameters) {
  ros::Time::init();  // whoever logs asks for it
  smore::BagChoices choices;
  if (!arguments.scenario.empty()) choices.scenario = arguments.scenario;
  choices.parameters = parameters;
  smore::BagEvidence bag = smore::readBag(arguments.bag, choices);
  for (const std::string& warning : bag.warnings) {
    std::cerr << "warning: " << arguments.bag << ": " << warning
              << "; the maps may differ from those of the running system" << std::endl;
  }
  return std::move(bag.evidence);
}

smore::Evidence evidenceOf(const Arguments& arguments,
                           const std::optional<smore::MethodParameters>& parameters) {
  if (arguments.evidence.empty() == arguments.bag.empty()) {
    throw smore::InputError("give either --evidence or --bag");
  }
  if (!arguments.bag.empty()) return fromBag(arguments, parameters);
  smore::Evidence evidence = smore::readEvidence(arguments.evidence, parameters);
  if (arguments.scenario.empty()) return evidence;
  smore::changeTask(arguments.scenario, &evidence.source);
  if (const std::size_t left_out = smore::leaveOutBesideThePlane(&evidence); left_out > 0) {
    std::cerr << arguments.evidence << ": " << left_out
              << " observations beside the plane of motion are left out" << std::endl;
  }
  return evidence;
}

int run(const Arguments& arguments) {
  std::optional<smore::MethodParameters> parameters;
  if (!arguments.method_parameters.empty()) {
    parameters = smore::loadMethodParameters(arguments.method_parameters);
  }
  smore::Evidence evidence = evidenceOf(arguments, parameters);
  smore::RebuildChanges changes;
  if (!arguments.method.empty()) changes.method = smore::methodKind(arguments.method);
  if (arguments.voxel_size > 0.0) changes.voxel_size = arguments.voxel_size;
  if (parameters) {
    smore::checkTakesParameters(changes.method.value_or(evidence.source.method));
  }
  const std::string problem =
      smore::problemOfMapsDirectory(arguments.output, smore::filesOf(evidence.source.task));
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
