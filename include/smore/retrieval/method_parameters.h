// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "smore/common/json.h"
#include "smore/common/parameters.h"
#include "smore/mapping/joint_belief.h"
#include "smore/mapping/sequential_belief.h"
#include "smore/planning/risk_planner.h"
#include "smore/retrieval/method_kind.h"

namespace smore {

/// What the method paper may be told: where the publication is silent.
struct PaperParameters {
  SequentialBeliefParameters belief;
  double step_in_voxels = 1.0;  ///< longest edge of the planner's tree [voxels], positive; as there
};

/// What the methods smore (belief, planner) and paper may be told. What a scenario states (voxel
/// size, plane of motion) and the seed are set by makeMethod.
struct MethodParameters {
  JointBeliefParameters belief;
  RiskPlannerParameters planner;
  PaperParameters paper;
};

/// One parameter: its key, where its value lies, and its valid range.
struct ParameterField {
  std::string key;
  std::variant<double*, int*> value;
  Range range;
};

/// Fields that belong together in a file, of one method.
struct ParameterSection {
  MethodKind method;
  std::string name;
  std::vector<ParameterField> fields;
};

/// All that a parameter file may set, views into `parameters`: the one list that files are read by
/// and that results record (docs/experiments.md).
std::vector<ParameterSection> parameterSections(MethodParameters* parameters);

/// The defaults, changed by what a YAML file sets, which may have sections of several methods.
/// InputError with all problems of the file: unknown keys, wrong types, values out of range.
MethodParameters loadMethodParameters(const std::string& file,
                                      const MethodParameters& defaults = {});

/// The same from a mapping that was parsed already; `source` names it in messages.
MethodParameters readMethodParameters(const YAML::Node& mapping, const std::string& source,
                                      const MethodParameters& defaults = {});

/// Whether a method has parameters.
bool takesParameters(MethodKind method);

/// InputError where a method has none.
void checkTakesParameters(MethodKind method);

/// All parameters of a method, in the form in which they are read.
Json toJson(MethodKind method, MethodParameters parameters);

}  // namespace smore
