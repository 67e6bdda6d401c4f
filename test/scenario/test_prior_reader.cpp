// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "meshes.h"
#include "smore/common/result.h"
#include "smore/scenario/scenario.h"
#include "smore/scenario/scenario_json.h"
#include "temporary_directory.h"

namespace smore {
namespace {

const char* const kTask = R"(
name: small
task: retrieve
voxel_size: 0.03
motion: planar
robot: cartesian
start: {position: [0, 0, 0]}
goal: {position: [-1, 0, 0]}
workspace: {min: [-2, -1, 0], max: [1, 1, 0]}
)";

class PriorReader : public testing::Test {
 protected:
  Scenario load(const std::string& prior) {
    return loadScenario(directory_.write("scene.yaml", kTask + prior));
  }

  void expectProblem(const std::string& prior, const std::string& part) {
    std::string problem = "none";
    try {
      load(prior);
    } catch (const InputError& error) {
      problem = error.what();
    }
    EXPECT_NE(problem.find(part), std::string::npos) << "expected '" << part << "' in: " << problem;
    EXPECT_NE(problem.find("scene.yaml: "), std::string::npos) << problem;
  }

  TemporaryDirectory directory_;
};

TEST_F(PriorReader, priorsNeedNothingButTheirSource) {
  directory_.write("part.obj", cubeObj());
  directory_.write("front.pcd", "");
  const Scenario scenario = load(R"(
prior:
  object: [{source: truth}, {source: part.obj, position: [1, 2, 3], scale: [2, 2, 2]}]
  world: [{source: front.pcd, min: [0, 0, 0], max: [1, 1, 1], offset: [0.06, 0, 0], confidence: 0.9}]
)");
  ASSERT_EQ(scenario.prior.object.size(), 2U);
  EXPECT_EQ(scenario.prior.object[0].format, PriorFormat::kTruth);
  EXPECT_FALSE(scenario.prior.object[0].box.has_value());
  EXPECT_EQ(scenario.prior.object[0].offset, Vec3(0, 0, 0));
  EXPECT_EQ(scenario.prior.object[0].confidence, 0.999);
  EXPECT_EQ(scenario.prior.object[1].format, PriorFormat::kMesh);
  EXPECT_EQ(scenario.prior.object[1].file, directory_.path() + "/part.obj");
  EXPECT_EQ(Vec3(scenario.prior.object[1].pose.translation()), Vec3(1, 2, 3));
  EXPECT_EQ(scenario.prior.object[1].scale, Vec3(2, 2, 2));
  ASSERT_EQ(scenario.prior.world.size(), 1U);
  EXPECT_EQ(scenario.prior.world[0].format, PriorFormat::kCloud);
  EXPECT_EQ(scenario.prior.world[0].box->max, Vec3(1, 1, 1));
  EXPECT_EQ(scenario.prior.world[0].offset, Vec3(0.06, 0, 0));
  EXPECT_EQ(scenario.prior.world[0].confidence, 0.9);
  const auto json = nlohmann::json::parse(toJson(scenario));
  EXPECT_EQ(json["prior"]["object"][1]["format"], "mesh");
  EXPECT_EQ(json["prior"]["world"][0]["confidence"], 0.9);
}

TEST_F(PriorReader, wrongPriorsAreToldWithTheirRemedy) {
  const auto entry = [](const std::string& keys) { return "prior: {world: [{" + keys + "}]}\n"; };
  expectProblem(entry("confidence: 0.9"), "source: missing");
  expectProblem(entry("source: part.step"), "is none of: truth, a mesh");
  expectProblem(entry("source: nowhere.stl"), "no file");
  expectProblem(entry("source: truth, position: [0, 0, 0]"), "position: unknown key");
  expectProblem(entry("source: truth, confidence: 1.0"), "confidence: '1.0' is out of range");
  expectProblem(entry("source: truth, min: [0, 0, 0]"), "max: missing");
  expectProblem(entry("source: truth, min: [0, 2, 0], max: [1, 1, 1]"), "not below max");
  expectProblem("prior: {moon: []}\n", "moon: unknown key");
  expectProblem("prior: {world: []}\n", "world");
}

}  // namespace
}  // namespace smore
