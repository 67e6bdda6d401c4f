// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "../common/refusal.h"
#include "smore/scenario/scenario_files.h"
#include "temporary_directory.h"

namespace smore {
namespace {

class FindScenario : public testing::Test {
 protected:
  FindScenario() { directory_.write("scene.yaml", "name: scene"); }

  std::string problemOf(const std::string& name_or_path) {
    return refusalOf([&] { return findScenario(name_or_path, directory_.path()); });
  }

  void expectProblem(const std::string& name_or_path, const std::string& part) {
    const std::string problem = problemOf(name_or_path);
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
    EXPECT_NE(problem.find("'" + name_or_path + "'"), std::string::npos) << problem;
    EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
  }

  TemporaryDirectory directory_;
};

TEST_F(FindScenario, takesAPathThenAName) {
  const std::string file = directory_.path() + "/scene.yaml";
  EXPECT_EQ(findScenario(file, "/nowhere"), file);
  EXPECT_EQ(findScenario("scene", directory_.path()), file);
}

TEST_F(FindScenario, saysWhatNamesThereAre) {
  directory_.write("007.yaml", "name: x");
  expectProblem("scone", "one of: 007, scene");
}

TEST_F(FindScenario, saysWhereItLooksForAPath) {
  expectProblem("my/scone.yaml", std::filesystem::current_path().string());
  expectProblem("scone.yaml", "give the absolute path");
  expectProblem("/nowhere/scone.yaml", "no readable file");
  EXPECT_EQ(problemOf("scone.yaml").find("scene,"), std::string::npos);
}

TEST_F(FindScenario, tellsADirectory) { expectProblem(directory_.path(), "is a directory"); }

TEST(ShippedScenarioDirectory, holdsTheReferenceScene) {
  EXPECT_TRUE(std::filesystem::exists(shippedScenarioDirectory() + "/s_shape_two_pegs.yaml"));
}

}  // namespace
}  // namespace smore
