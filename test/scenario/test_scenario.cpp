// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "../common/refusal.h"
#include "meshes.h"
#include "smore/common/result.h"
#include "smore/scenario/scenario.h"
#include "smore/scenario/scenario_json.h"
#include "temporary_directory.h"

namespace smore {
namespace {

const char* const kHead = R"(
name: small
task: retrieve
voxel_size: 0.03
motion: planar
robot: cartesian
)";
const char* const kObject =
    "object: {shapes: [{type: box, size: [1, 2, 3], position: [0, 0, 0]}]}\n";
const char* const kEnvironment =
    "environment: {shapes: [{type: sphere, radius: 0.5, position: [5, 0, 0]}]}\n";
const char* const kPoses = "start: {position: [0, 0, 0]}\ngoal: {position: [-1, 0, 0]}\n";
const char* const kWorkspace = "workspace: {min: [-2, -1, 0], max: [1, 1, 0]}\n";

std::string minimal() { return std::string(kHead) + kObject + kEnvironment + kPoses + kWorkspace; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class ScenarioTest : public testing::Test {
 protected:
  Scenario load(const std::string& content) {
    return loadScenario(directory_.write("scene.yaml", content));
  }

  std::string problemOf(const std::string& content) {
    return refusalOf([&] { return load(content); });
  }

  void expectProblem(const std::string& content, const std::string& part) {
    const std::string problem = problemOf(content);
    EXPECT_NE(problem.find(part), std::string::npos) << "expected '" << part << "' in: " << problem;
    EXPECT_NE(problem.find("scene.yaml: "), std::string::npos) << problem;
  }

  TemporaryDirectory directory_;
};

TEST_F(ScenarioTest, anArmOfAnotherMakeIsGivenByThePathOfItsDescription) {
  const std::string text = minimal();
  const Scenario scenario = load(replaced(text, "cartesian", "arms/mine.urdf"));
  EXPECT_EQ(scenario.robot, RobotKind::kUrdf);
  EXPECT_EQ(scenario.robot_urdf, directory_.path() + "/arms/mine.urdf");
  EXPECT_EQ(load(replaced(text, "cartesian", "/arms/mine.urdf")).robot_urdf, "/arms/mine.urdf");
  EXPECT_NO_THROW(requireArm(scenario));
  expectProblem(replaced(text, "cartesian", "urdf"), "ur16e, FILE.urdf, got 'urdf'");
  EXPECT_THROW(requireArm(load(text)), InputError);
}

TEST_F(ScenarioTest, keysAfterTheGoalHaveDefaults) {
  const Scenario scenario = load(minimal());
  EXPECT_EQ(scenario.name, "small");
  EXPECT_EQ(scenario.task, Task::kRetrieve);
  EXPECT_EQ(scenario.motion, Motion::kPlanar);
  EXPECT_EQ(scenario.robot, RobotKind::kCartesian);
  EXPECT_EQ(scenario.on_contact, OnContact::kReset);
  EXPECT_DOUBLE_EQ(scenario.goal_position_tolerance, 0.02);
  EXPECT_DOUBLE_EQ(scenario.goal_angle_tolerance, 0.1);
  EXPECT_DOUBLE_EQ(scenario.friction, 0.3);
  EXPECT_DOUBLE_EQ(scenario.linear_speed, 0.1);
  EXPECT_DOUBLE_EQ(scenario.angular_speed, 0.5);
  EXPECT_DOUBLE_EQ(scenario.contact_force, 5.0);
  EXPECT_DOUBLE_EQ(scenario.free_force, 0.5);
  EXPECT_DOUBLE_EQ(scenario.object_mass, 0.5);
  EXPECT_EQ(scenario.reconstruct_touches, 300);
  EXPECT_EQ(scenario.wrench_noise.force_stddev, 0.0);
  EXPECT_EQ(scenario.perturb.position, 0.0);
  EXPECT_TRUE(scenario.T_world_base.isApprox(Pose::Identity()));
}

TEST_F(ScenarioTest, everyKeyReachesItsMember) {
  const Scenario scenario = load(minimal() + R"(
goal_tolerance: {position: 0.03, angle: 0.2}
friction: 0.4
speed: {linear: 0.2, angular: 0.6}
contact_force: 6.0
free_force: 0.6
wrench_noise: {force_stddev: 1, torque_stddev: 2, force_bias: [3, 4, 5], torque_bias: [6, 7, 8], force_drift: 9}
line_noise: {direction: 0.1, offset: 0.2}
on_contact: retreat
reconstruct: {touches: 7}
perturb: {position: 0.01, angle: 0.05}
object_mass: 0.7
robot_base: {position: [1, 2, 3]}
gripper_object: {position: [4, 5, 6], rpy: [0, 0, 1]}
)");
  EXPECT_DOUBLE_EQ(scenario.goal_position_tolerance, 0.03);
  EXPECT_DOUBLE_EQ(scenario.goal_angle_tolerance, 0.2);
  EXPECT_DOUBLE_EQ(scenario.friction, 0.4);
  EXPECT_DOUBLE_EQ(scenario.linear_speed, 0.2);
  EXPECT_DOUBLE_EQ(scenario.angular_speed, 0.6);
  EXPECT_DOUBLE_EQ(scenario.contact_force, 6.0);
  EXPECT_DOUBLE_EQ(scenario.free_force, 0.6);
  EXPECT_DOUBLE_EQ(scenario.wrench_noise.force_stddev, 1.0);
  EXPECT_DOUBLE_EQ(scenario.wrench_noise.torque_stddev, 2.0);
  EXPECT_EQ(scenario.wrench_noise.force_bias, Vec3(3, 4, 5));
  EXPECT_EQ(scenario.wrench_noise.torque_bias, Vec3(6, 7, 8));
  EXPECT_DOUBLE_EQ(scenario.wrench_noise.force_drift, 9.0);
  EXPECT_DOUBLE_EQ(scenario.line_noise.direction, 0.1);
  EXPECT_DOUBLE_EQ(scenario.line_noise.offset, 0.2);
  EXPECT_EQ(scenario.on_contact, OnContact::kRetreat);
  EXPECT_EQ(scenario.reconstruct_touches, 7);
  EXPECT_DOUBLE_EQ(scenario.perturb.position, 0.01);
  EXPECT_DOUBLE_EQ(scenario.perturb.angle, 0.05);
  EXPECT_DOUBLE_EQ(scenario.object_mass, 0.7);
  EXPECT_EQ(Vec3(scenario.T_world_base.translation()), Vec3(1, 2, 3));
  EXPECT_NEAR(angleBetween(scenario.T_gripper_object, Pose::Identity()), 1.0, 1e-12);
}

TEST_F(ScenarioTest, allProblemsAreReportedAtOnce) {
  const std::string problem = problemOf("name: x\nfrction: 0.3\nvoxel_size: -1\ntask: fetch\n");
  for (const char* part : {"frction: unknown key", "voxel_size: '-1' is out of range",
                           "task: expected", "motion: missing", "robot: missing", "start: missing",
                           "goal: missing", "workspace: missing"}) {
    EXPECT_NE(problem.find(part), std::string::npos) << part << " in:\n" << problem;
  }
}

TEST_F(ScenarioTest, withoutObjectAndEnvironmentItIsATask) {
  const Scenario task = load(std::string(kHead) + kPoses + kWorkspace + "speed: {linear: 0.02}\n");
  EXPECT_FALSE(task.hasScene());
  EXPECT_TRUE(load(minimal()).hasScene());
  EXPECT_DOUBLE_EQ(task.linear_speed, 0.02);
  EXPECT_EQ(nlohmann::json::parse(toJson(task)).count("object"), 0u);
  EXPECT_EQ(nlohmann::json::parse(toJson(load(minimal()))).count("object"), 1u);
  EXPECT_NO_THROW(requireScene(load(minimal())));
  try {
    requireScene(task);
    FAIL() << "nobody can simulate a task";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("small: object, environment: missing"),
              std::string::npos);
  }
}

TEST_F(ScenarioTest, anObjectWithoutAnEnvironmentOrTheReverseIsAProblem) {
  expectProblem(replaced(minimal(), kObject, ""), "object: missing");
  expectProblem(replaced(minimal(), kEnvironment, ""), "environment: missing");
}

TEST_F(ScenarioTest, impossibleValuesAreProblems) {
  const auto with = [](const std::string& more) { return minimal() + more; };
  expectProblem(with("friction: -0.1\n"), "friction");
  expectProblem(with("friction: much\n"), "expected a finite number");
  expectProblem(with("friction: .nan\n"), "expected a finite number");
  expectProblem(with("friction:\n"), "friction");
  expectProblem(with("speed: {linear: 0}\n"), "speed.linear");
  expectProblem(with("speed: {linar: 1}\n"), "speed.linar: unknown key");
  expectProblem(with("speed: fast\n"), "speed: expected a mapping");
  expectProblem(with("object_mass: 0\n"), "object_mass");
  expectProblem(with("contact_force: 0.4\n"), "free_force: not below contact_force");
  expectProblem(with("on_contact: ignore\n"), "on_contact: expected one of reset, retreat");
  expectProblem(with("reconstruct: {touches: 1.5}\n"), "reconstruct.touches");
  expectProblem(with("perturb: {angle: 4}\n"), "perturb.angle");
  expectProblem(with("wrench_noise: {force_bias: 3}\n"), "wrench_noise.force_bias");
  expectProblem(with("goal_tolerance: {position: 0}\n"), "goal_tolerance.position");
  expectProblem(with("robot_base: {rpy: [0, 0, 0]}\n"), "robot_base.position: missing");
}

TEST_F(ScenarioTest, badShapesAreProblems) {
  const auto with = [](const std::string& shape) {
    return replaced(minimal(), "{type: box, size: [1, 2, 3], position: [0, 0, 0]}", shape);
  };
  expectProblem(with("{type: cone, position: [0, 0, 0]}"),
                "object.shapes[0].type: expected one of");
  expectProblem(with("{type: box, size: [1, 0, 3], position: [0, 0, 0]}"), "object.shapes[0].size");
  expectProblem(with("{type: box, size: [1, 2, 3]}"), "object.shapes[0].position: missing");
  expectProblem(with("{type: box, size: [1, 2], position: [0, 0, 0]}"), "three finite numbers");
  expectProblem(with("{type: sphere, radius: -1, position: [0, 0, 0]}"), "object.shapes[0].radius");
  expectProblem(with("{type: sphere, size: 1, radius: 1, position: [0, 0, 0]}"),
                "size: unknown key");
  expectProblem(with("{type: cylinder, radius: 1, position: [0, 0, 0]}"), "length: missing");
  expectProblem(with("{type: mesh, file: gone.stl, position: [0, 0, 0]}"), "gone.stl");
  expectProblem(replaced(minimal(), kObject, "object: {shapes: []}\n"),
                "object.shapes: expected a list");
  expectProblem(replaced(minimal(), kObject, "object: {}\n"), "object.shapes: missing");
}

TEST_F(ScenarioTest, startAndGoalMustLieInTheMotionSpace) {
  const auto with_goal = [](const std::string& goal) {
    return replaced(minimal(), "goal: {position: [-1, 0, 0]}", "goal: " + goal);
  };
  expectProblem(with_goal("{position: [-9, 0, 0]}"), "goal: outside of the workspace");
  expectProblem(with_goal("{position: [-1, 0, 0], rpy: [0.2, 0, 0]}"),
                "beside the plane of motion, the x-y plane of the start pose");
  EXPECT_NO_THROW((void)load(with_goal("{position: [-1, 0, 0], rpy: [0.00005, 0, 0]}")))
      << "people round";
  expectProblem(replaced(minimal(), "min: [-2", "min: [0.5"), "start: outside of the workspace");
  expectProblem(replaced(minimal(), "min: [-2", "min: [3"), "workspace: min is above max");
  const std::string spatial = replaced(with_goal("{position: [-1, 0, 0], rpy: [0.2, 0, 0]}"),
                                       "motion: planar", "motion: spatial");
  EXPECT_EQ(load(spatial).motion, Motion::kSpatial);
}

TEST_F(ScenarioTest, meshesAreFoundBesideTheFile) {
  directory_.write("cube.obj", cubeObj());
  directory_.write("ell.obj", ellObj());
  const auto object = [](const std::string& file) {
    return replaced(minimal(), "{type: box, size: [1, 2, 3], position",
                    "{type: mesh, file: " + file + ", scale: [2, 1, 1], position");
  };
  EXPECT_NEAR(boundsOf(load(object("cube.obj")).object).max.x(), 2.0, 1e-12);
  const auto& ell = std::get<MeshShape>(load(object("ell.obj")).object[0].geometry);
  EXPECT_EQ(ell.parts.size(), 2u) << "an object's concave mesh moves as convex parts";
  EXPECT_LT(ell.parts_error, 1e-6);
  const std::string environment = replaced(minimal(), "{type: sphere, radius: 0.5, position",
                                           "{type: mesh, file: ell.obj, position");
  EXPECT_EQ(load(environment).environment.size(), 1u);
}

TEST_F(ScenarioTest, unreadableFilesAreProblems) {
  EXPECT_THROW(loadScenario(directory_.path() + "/gone.yaml"), InputError);
  expectProblem("name: [unclosed", "not valid YAML");
  expectProblem("- a list\n", "expected a mapping");
  expectProblem("", "expected a mapping");
}

TEST_F(ScenarioTest, anglesInDegreesAreProblems) {
  const auto with = [](const std::string& more) { return minimal() + more; };
  expectProblem(replaced(minimal(), "goal: {position: [-1, 0, 0]}",
                         "goal: {position: [-1, 0, 0], rpy: [0, 0, 90]}"),
                "goal.rpy: '90' is beyond 2 pi; angles are in radians");
  expectProblem(with("perturb: {angle: 10}\n"), "10 looks like degrees");
  expectProblem(with("goal_tolerance: {angle: 10}\n"), "10 looks like degrees");
}

TEST_F(ScenarioTest, whatTheOctreesCannotHoldIsAProblem) {
  // 32768 voxels of 1 mm to either side, less the object's half diagonal of sqrt(14) / 2 m.
  const std::string fine = replaced(minimal(), "voxel_size: 0.03", "voxel_size: 0.001");
  EXPECT_EQ(load(replaced(fine, "max: [1,", "max: [30.8,")).name, "small");
  expectProblem(replaced(fine, "max: [1,", "max: [31,"), "keep it from -30.8972 to 30.8972 m");
  expectProblem(replaced(fine, "min: [-2,", "min: [-31,"), "raise voxel_size");
}

// Loads each file of a shipped folder; of these, how many there are.
int countOfFiles(const std::string& folder, bool with_scene) {
  int count = 0;
  const std::filesystem::path directory = SMORE_SOURCE_DIR "/config/" + folder;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() != ".yaml") continue;
    const Scenario scenario = loadScenario(entry.path().string());
    EXPECT_EQ(scenario.name, entry.path().stem().string());
    EXPECT_EQ(scenario.hasScene(), with_scene) << scenario.name;
    ++count;
  }
  return count;
}

TEST(ShippedScenarios, allLoadAndAreNamedAsTheirFiles) {
  EXPECT_GT(countOfFiles("scenarios", true), 0);
  EXPECT_GT(countOfFiles("tasks", false), 0);
}

}  // namespace
}  // namespace smore
