// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/method_parameters.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "smore/common/result.h"
#include "smore/common/yaml_file.h"

namespace smore {
namespace {

constexpr Range kLength{1e-3, 1e3};     // [units of length]
constexpr Range kExtent{0.0, 1e3};      // [units of length]; 0: none
constexpr Range kUnit{0.0, 4.4};        // of length [m], to the largest inferred; 0: it is inferred
constexpr double kLeastUnit = 1e-3;     // [m]: half of the smallest that is inferred
constexpr double kLeastBalls = 0.01;    // [units of length]: the lattices' cells are a third of it
constexpr Range kAngle{1e-4, 3.0};      // [rad]
constexpr Range kWeight{0.01, 1e3};     // odds
constexpr Range kStrength{0.0, 100.0};  // 0: off
constexpr Range kMetres{1e-3, 1e3};     // [m]
constexpr Range kVoxels{0.1, 100.0};    // [voxels]
constexpr Range kShare{1e-6, 0.999};
constexpr Range kShareOrNone{0.0, 1.0};  // 0: off
constexpr Range kSteps{1, 1000};
constexpr Range kSweeps{0, 1000};
constexpr Range kContacts{10, 1000};
constexpr Range kCount{1, 1e6};
constexpr Range kTries{0, 1e6};
constexpr Range kSeconds{1e-3, 1e6};  // of wall time

ParameterSection beliefSection(JointBeliefParameters* belief) {
  FeatureParameters& feature = belief->feature;
  DistributionParameters& distribution = belief->distribution;
  return {MethodKind::kSmore,
          "belief",
          {{"radius", &feature.radius, kLength},
           {"tolerance", &feature.tolerance, kExtent},
           {"reach", &feature.reach, kLength},
           {"decay", &feature.decay, kLength},
           {"position_cell", &belief->free_space.position_cell, kLength},
           {"angle_cell", &belief->free_space.angle_cell, kAngle},
           {"object_attraction_scale", &distribution.object.scale, kLength},
           {"object_attraction_base", &distribution.object.base, kWeight},
           {"world_attraction_scale", &distribution.world.scale, kLength},
           {"world_attraction_base", &distribution.world.base, kWeight},
           {"attraction_exponent", &distribution.exponent, kStrength},
           {"conflict_cost", &distribution.conflict_cost, kStrength},
           {"false_contact", &distribution.false_contact, kShare},
           {"temperatures", &distribution.temperatures, kSteps},
           {"least_share", &distribution.least_share, kShare},
           {"sweeps", &distribution.sweeps, kSweeps},
           {"unit", &belief->unit, kUnit},
           {"most_contacts", &belief->most_contacts, kContacts},
           {"shortest_patch", &belief->extent.shortest, kLength},
           {"object_patch", &belief->extent.object_longest, kLength},
           {"world_patch", &belief->extent.world_longest, kLength},
           {"prior_scale", &belief->prior.scale, kLength},
           {"prior_weight", &belief->prior.weight, kStrength}}};
}

ParameterSection plannerSection(RiskPlannerParameters* planner) {
  return {MethodKind::kSmore,
          "planner",
          {{"iterations", &planner->iterations, kCount},
           {"paths", &planner->paths, kCount},
           {"improvements", &planner->improvements, kTries},
           {"improvements_in_space", &planner->improvements_in_space, kTries},
           {"postures", &planner->postures, kTries},
           {"kept_postures", &planner->kept_postures, kCount},
           {"alternatives", &planner->alternatives, kTries},
           {"time_limit", &planner->time_limit, kSeconds},
           {"step", &planner->step, kLength},
           {"lever", &planner->lever, kLength},
           {"touch_cost", &planner->objective.touch_cost, kLength},
           {"give", &planner->objective.give, kLength},
           {"surprise_share_in_space", &planner->surprise_share_in_space, kShareOrNone},
           {"surprises_of_known_object", &planner->surprises_of_known_object, kStrength}}};
}

ParameterSection paperSection(PaperParameters* paper) {
  return {MethodKind::kPaper,
          "paper",
          {{"line_half_length", &paper->belief.line_half_length, kMetres},
           {"free_distance", &paper->belief.free_distance, kMetres},
           {"free_angle", &paper->belief.free_angle, kAngle},
           {"step_in_voxels", &paper->step_in_voxels, kVoxels}}};
}

void read(const ParameterField& field, ParameterReader* reader) {
  if (!reader->has(field.key)) return;
  if (const auto* number = std::get_if<double*>(&field.value)) {
    reader->number(field.key, *number, field.range);
  } else {
    reader->integer(field.key, std::get<int*>(field.value), static_cast<int>(field.range.min),
                    static_cast<int>(field.range.max));
  }
}

// What no parameter's own range says.
void checkTogether(const JointBeliefParameters& belief, ParameterReader* reader) {
  if (belief.feature.conflictDistance() < kLeastBalls) {
    reader->error("belief.tolerance", "must be below twice belief.radius, by 0.01 at least");
  }
  if (belief.unit != 0.0 && belief.unit < kLeastUnit) {
    reader->error("belief.unit", "must be 0 (it is inferred) or 0.001 m at least");
  }
  const ExtentParameters& extent = belief.extent;
  if (extent.shortest > std::min(extent.object_longest, extent.world_longest)) {
    reader->error("belief.shortest_patch",
                  "must not be above belief.object_patch and belief.world_patch");
  }
}

}  // namespace

std::vector<ParameterSection> parameterSections(MethodParameters* parameters) {
  return {beliefSection(&parameters->belief), plannerSection(&parameters->planner),
          paperSection(&parameters->paper)};
}

MethodParameters readMethodParameters(const YAML::Node& mapping, const std::string& source,
                                      const MethodParameters& defaults) {
  MethodParameters parameters = defaults;
  ParameterReader reader(mapping, source);
  for (const ParameterSection& section : parameterSections(&parameters)) {
    if (!reader.has(section.name)) continue;
    ParameterReader nested = reader.nested(section.name);
    for (const ParameterField& field : section.fields) read(field, &nested);
    nested.finishNested();
  }
  checkTogether(parameters.belief, &reader);
  reader.finish();
  return parameters;
}

MethodParameters loadMethodParameters(const std::string& file, const MethodParameters& defaults) {
  MethodParameters parameters = readMethodParameters(loadYaml(file), file, defaults);
  // Not of recorded ones, with which nothing is planned.
  if (2.0 * parameters.planner.lever < parameters.belief.feature.reach) {
    throw InputError(file +
                     ": planner.lever: must be half of belief.reach at least, or turns pass "
                     "through matter unseen");
  }
  return parameters;
}

bool takesParameters(MethodKind method) { return !toJson(method, {}).empty(); }

void checkTakesParameters(MethodKind method) {
  if (takesParameters(method)) return;
  throw InputError("the method " + methodName(method) +
                   " has no parameters; leave them out, or use smore or paper");
}

Json toJson(MethodKind method, MethodParameters parameters) {
  Json json = Json::object();
  for (const ParameterSection& section : parameterSections(&parameters)) {
    if (section.method != method) continue;
    Json& values = json[section.name] = Json::object();
    for (const ParameterField& field : section.fields) {
      std::visit([&](const auto* value) { values[field.key] = *value; }, field.value);
    }
  }
  return json;
}

}  // namespace smore
