// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "smore/common/result.h"
#include "smore/retrieval/method_parameters.h"

namespace smore {
namespace {

class MethodParametersFile : public testing::Test {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }

  MethodParameters load(const std::string& text) {
    std::ofstream(file_) << text;
    return loadMethodParameters(file_);
  }

  std::string errorsOf(const std::string& text) {
    try {
      load(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::string file_ = testing::TempDir() + "method_parameters.yaml";
};

TEST_F(MethodParametersFile, ChangesWhatItNamesAndKeepsTheRest) {
  const auto parameters =
      load("belief: {radius: 0.3, sweeps: 7}\nplanner: {touch_cost: 5, iterations: 10}");
  EXPECT_EQ(parameters.belief.feature.radius, 0.3);
  EXPECT_EQ(parameters.belief.distribution.sweeps, 7);
  EXPECT_EQ(parameters.planner.objective.touch_cost, 5.0);
  EXPECT_EQ(parameters.planner.iterations, 10);
  EXPECT_EQ(parameters.belief.feature.decay, FeatureParameters{}.decay);
  EXPECT_EQ(parameters.planner.paths, RiskPlannerParameters{}.paths);
}

TEST_F(MethodParametersFile, HasASectionOfTheMethodPaper) {
  const auto parameters = load("paper: {free_distance: 0.01, step_in_voxels: 2}");
  EXPECT_EQ(parameters.paper.belief.free_distance, 0.01);
  EXPECT_EQ(parameters.paper.step_in_voxels, 2.0);
  EXPECT_EQ(parameters.paper.belief.free_angle, SequentialBeliefParameters{}.free_angle);
}

TEST_F(MethodParametersFile, AreRecordedOfTheirMethodAlone) {
  const Json of_paper = toJson(MethodKind::kPaper, {});
  EXPECT_EQ(of_paper.size(), 1U);
  EXPECT_EQ(of_paper.at("paper").at("free_distance"), 0.03);
  EXPECT_FALSE(toJson(MethodKind::kSmore, {}).contains("paper"));
  EXPECT_FALSE(takesParameters(MethodKind::kCspace));
  EXPECT_THROW(checkTakesParameters(MethodKind::kCspace), InputError);
}

TEST_F(MethodParametersFile, ChangesTheDefaultsOfTheCaller) {
  load("belief: {radius: 0.3}");
  MethodParameters defaults;
  defaults.planner.time_limit = 2.0;
  EXPECT_EQ(loadMethodParameters(file_, defaults).planner.time_limit, 2.0);
  EXPECT_NE(errorsOf("belief: {reach: 8}").find("planner.lever"), std::string::npos);
  load("belief: {reach: 8}\nplanner: {lever: 4}");
  EXPECT_EQ(loadMethodParameters(file_).belief.feature.reach, 8.0);
  load("planner: {time_limit: 7}");
  EXPECT_EQ(loadMethodParameters(file_, defaults).planner.time_limit, 7.0);
}

TEST_F(MethodParametersFile, TellsAllErrorsAtOnce) {
  const std::string errors =
      errorsOf("belief: {radius: -1, sweeps: 1.5, speed: 3}\nplanner: {paths: many}\nextra: 1");
  for (const char* part :
       {"belief.radius", "belief.sweeps", "belief.speed: unknown", "planner.paths", "extra"}) {
    EXPECT_NE(errors.find(part), std::string::npos) << part << " in " << errors;
  }
}

TEST_F(MethodParametersFile, RefusesBallsThatNeverContradictEachOther) {
  EXPECT_NE(errorsOf("belief: {radius: 0.01, tolerance: 0.02}").find("belief.tolerance"),
            std::string::npos);
}

TEST_F(MethodParametersFile, RefusesUnitsThatNoLatticeHolds) {
  EXPECT_NE(errorsOf("belief: {unit: 1.0e-308}").find("belief.unit"), std::string::npos);
  EXPECT_NE(errorsOf("belief: {radius: 0.01, tolerance: 0.0199}").find("belief.tolerance"),
            std::string::npos);
  EXPECT_EQ(load("belief: {unit: 0.001}").belief.unit, 0.001);
}

TEST_F(MethodParametersFile, RefusesALargestPatchBelowTheSmallest) {
  EXPECT_NE(errorsOf("belief: {world_patch: 0.01}").find("belief.shortest_patch"),
            std::string::npos);
  EXPECT_EQ(load("belief: {world_patch: 0.2}").belief.extent.world_longest, 0.2);
}

TEST_F(MethodParametersFile, DefaultsLieInTheirRanges) {
  MethodParameters parameters;
  for (const ParameterSection& section : parameterSections(&parameters)) {
    for (const ParameterField& field : section.fields) {
      const double value =
          std::visit([](const auto* number) { return static_cast<double>(*number); }, field.value);
      EXPECT_GE(value, field.range.min) << field.key;
      EXPECT_LE(value, field.range.max) << field.key;
    }
  }
}

}  // namespace
}  // namespace smore
