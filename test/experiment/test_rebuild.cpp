// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "../contact/distance_to_line.h"
#include "../scenario/temporary_directory.h"
#include "bar_behind_peg.h"
#include "smore/common/result.h"
#include "smore/experiment/experiment.h"
#include "smore/experiment/rebuild.h"
#include "smore/experiment/trial_recording.h"
#include "smore/experiment/trial_truth.h"

namespace smore {
namespace {

const std::atomic<bool> kNotInterrupted{false};

// With a sensor that errs.
Scenario smallScene() {
  Scenario scenario = barBehindPeg();
  scenario.line_noise = {0.02, 0.002};
  return scenario;
}

std::string contentOf(const std::string& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  EXPECT_FALSE(content.str().empty()) << file;
  return content.str();
}

class RecordedTrial : public ::testing::TestWithParam<MethodKind> {
 protected:
  void SetUp() override {
    ExperimentParameters parameters;
    parameters.method = GetParam();
    parameters.seed = 11;
    parameters.max_collisions = 12;
    parameters.record_directory = directory_.path();
    parameters.maps_directory = directory_.path() + "/maps";
    result_ = runExperiment(smallScene(), parameters, kNotInterrupted, [](const auto&) {}).at(0);
    file_ = evidenceFile(directory_.path(), 11);
  }

  TemporaryDirectory directory_;
  TrialResult result_;
  std::string file_;
};

TEST_P(RecordedTrial, givesTheMapsOfTheTrialByteForByte) {
  const std::string output = directory_.path() + "/made/here";
  rebuild(readEvidence(file_), {}, output);
  for (const std::string map : {"/world.ot", "/object.ot"}) {
    EXPECT_EQ(contentOf(output + map), contentOf(directory_.path() + "/maps" + map)) << map;
  }
  const Json summary = Json::parse(contentOf(output + "/summary.json"));
  EXPECT_EQ(summary["method"], methodName(GetParam()));
  EXPECT_EQ(summary["contacts"], result_.collisions);
  EXPECT_EQ(summary["world_map"]["occupied"], result_.world_map.occupied);
}

TEST_P(RecordedTrial, tellsEachMotionAndWhatCameOfIt) {
  const Evidence evidence = readEvidence(file_);
  ASSERT_TRUE(evidence.outcome);
  EXPECT_EQ(evidence.outcome->success, result_.success);
  EXPECT_EQ(evidence.outcome->collisions, result_.collisions);
  ASSERT_EQ(evidence.motions.size(), result_.motions.size());
  for (std::size_t i = 0; i < evidence.motions.size(); ++i) {
    EXPECT_EQ(evidence.motions[i].risk, result_.motions[i].risk);
    EXPECT_EQ(evidence.motions[i].end == MotionEnd::kContact, result_.motions[i].touched);
    EXPECT_GE(evidence.motions[i].path.size(), 2u);
  }
}

TEST_P(RecordedTrial, holdsThePlaceOfEachContactOnItsLineAndOnBothSolids) {
  const Evidence evidence = readEvidence(file_);
  const TrialTruth truth = readTruth(file_);
  int lines = 0;
  for (const ContactObservation& observation : evidence.observations) {
    if (!observation.line) continue;
    ++lines;
    ASSERT_EQ(truth.contacts.count(observation.contact_id), 1u);
    for (const ContactPoint& point : truth.contacts.at(observation.contact_id)) {
      const Vec3 on_object = observation.T_world_object.inverse() * point.position;
      EXPECT_NEAR(signedDistance(truth.environment, point.position), 0.0, 0.004);
      EXPECT_NEAR(signedDistance(truth.object, on_object), 0.0, 0.004);
      EXPECT_LT(distanceToLine(*observation.line, on_object), 0.05) << "errors are 0.02 rad, 2 mm";
    }
  }
  EXPECT_EQ(lines, result_.collisions);
}

TEST_P(RecordedTrial, cutAnywhereMakesMapsOrIsRefused) {
  const std::string content = contentOf(file_);
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const std::size_t length = random() % content.size();
    const std::string cut = directory_.write("cut.evidence", content.substr(0, length));
    const bool complete = length > content.find("\"record\":\"truth\"");
    if (complete) {
      rebuild(readEvidence(cut), {}, directory_.path() + "/cut");
    } else {
      EXPECT_THROW(readEvidence(cut), InputError) << length;
    }
  }
}

TEST_P(RecordedTrial, canBeMadeWithAnotherMethodAndVoxelSize) {
  const std::string output = directory_.path() + "/other";
  RebuildChanges changes;
  changes.method = GetParam() == MethodKind::kPaper ? MethodKind::kSmore : MethodKind::kPaper;
  changes.voxel_size = 0.05;
  rebuild(readEvidence(file_), changes, output);
  const Json summary = Json::parse(contentOf(output + "/summary.json"));
  EXPECT_EQ(summary["method"], methodName(*changes.method));
  EXPECT_EQ(summary["voxel_size"], 0.05);
  EXPECT_GT(summary["world_map"]["voxels"], 0);
  changes.voxel_size = 1e-6;
  EXPECT_THROW(rebuild(readEvidence(file_), changes, output), InputError);
}

INSTANTIATE_TEST_SUITE_P(Methods, RecordedTrial,
                         ::testing::Values(MethodKind::kPaper, MethodKind::kCspace,
                                           MethodKind::kSmore),
                         [](const auto& instance) { return methodName(instance.param); });

TEST(TrialTruth, readsEverySolidBack) {
  Scenario scene;
  const Pose pose = makePose({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6});
  MeshShape mesh;
  mesh.file = "tetrahedron.stl";
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  scene.object = {{BoxShape{{0.1, 0.2, 0.3}}, pose}, {SphereShape{0.4}, pose}};
  scene.environment = {{CylinderShape{0.5, 0.6}, pose}, {mesh, pose}};
  const TemporaryDirectory directory;
  const TrialTruth truth = readTruth(directory.write(
      "some.evidence", solidsRecord(scene).dump() + "\n" +
                           contactTruthRecord(3, {{{1, 2, 3}, {4, 5, 6}, "object"}}).dump() +
                           "\n"));
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    const Vec3 point(normal(random), normal(random), normal(random));
    EXPECT_EQ(signedDistance(truth.object, point), signedDistance(scene.object, point));
    EXPECT_EQ(signedDistance(truth.environment, point), signedDistance(scene.environment, point));
  }
  ASSERT_EQ(truth.contacts.at(3).size(), 1u);
  EXPECT_EQ(truth.contacts.at(3)[0].force, Vec3(4, 5, 6));
  EXPECT_THROW(readTruth(directory.write("none.evidence", "{\"a\":1}\n")), InputError);
  EXPECT_THROW(
      readTruth(directory.write("bad.evidence", R"({"record":"truth","object":[{"type":"egg"}]})"
                                                "\n")),
      InputError);
}

}  // namespace
}  // namespace smore
