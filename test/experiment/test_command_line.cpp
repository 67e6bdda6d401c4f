// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "../common/refusal.h"
#include "smore/experiment/command_line.h"

namespace smore {
namespace {

namespace po = boost::program_options;

struct Values {
  std::string file;
  std::string method = "smore";
  int trials = 3;
  std::uint64_t seed = 1;
  double size = 0.0;
  bool quick = false;
};

po::options_description declare(Values* values) {
  po::options_description options("What it is for");
  auto add = options.add_options();
  add("file", po::value(&values->file)->required(), "what is read");
  add("method", new ChoiceOption(&values->method, {"paper", "smore"}), "how");
  add("trials", new NumberOption<int>(&values->trials, 1, 10), "how many");
  add("seed", new NumberOption<std::uint64_t>(&values->seed, 0, UINT64_MAX), "of the first");
  add("size", new NumberOption<double>(&values->size, 0.5, 2.0), "of a voxel");
  add("quick", po::bool_switch(&values->quick), "in haste");
  return options;
}

std::optional<std::string> read(std::vector<const char*> arguments, Values* values,
                                const std::string& positional = "") {
  arguments.insert(arguments.begin(), "/some/where/program");
  return readCommandLine(static_cast<int>(arguments.size()), arguments.data(), declare(values),
                         positional);
}

std::string problemOf(const std::vector<const char*>& arguments) {
  Values values;
  return refusalOf([&] { return read(arguments, &values); });
}

TEST(CommandLine, setsWhatIsGivenAndLeavesTheRest) {
  Values values;
  EXPECT_FALSE(
      read({"--file", "a b", "--trials=10", "--seed", "18446744073709551615", "--quick"}, &values));
  EXPECT_EQ(values.file, "a b");
  EXPECT_EQ(values.trials, 10);
  EXPECT_EQ(values.seed, UINT64_MAX);
  EXPECT_TRUE(values.quick);
  EXPECT_EQ(values.method, "smore");
  EXPECT_EQ(values.size, 0.0);
}

TEST(CommandLine, takesWhatIsNoOptionWhereSomethingTakesIt) {
  Values values;
  EXPECT_FALSE(read({"a.yaml", "--method", "paper"}, &values, "file"));
  EXPECT_EQ(values.file, "a.yaml");
  EXPECT_EQ(values.method, "paper");
  EXPECT_EQ(problemOf({"--file", "x", "stray"}),
            "'stray' was not expected; --help lists the options");
  EXPECT_EQ(problemOf({"--file", ""}), "--file: is empty; --help lists the options");
}

TEST(CommandLine, namesTheOptionAndWhatItTakes) {
  const std::string end = "; --help lists the options";
  EXPECT_EQ(problemOf({}), "--file is required" + end);
  for (const std::string number : {"0", "11", "3.5", "three", "", "3 "}) {
    EXPECT_EQ(problemOf({"--file", "x", "--trials", number.c_str()}),
              "--trials: '" + number + "' is not a number from 1 to 10" + end);
  }
  for (const std::string number : {"nan", "inf", "0.4", "-1"}) {
    EXPECT_EQ(problemOf({"--file", "x", "--size", number.c_str()}),
              "--size: '" + number + "' is not a number from 0.5 to 2" + end);
  }
  EXPECT_EQ(problemOf({"--file", "x", "--seed", "-1"}),
            "--seed: '-1' is not a number from 0 to 18446744073709551615" + end);
  EXPECT_EQ(problemOf({"--file", "x", "--method", "guess"}),
            "--method: 'guess' is not one of paper|smore" + end);
}

TEST(CommandLine, refusesWhatItDoesNotKnow) {
  EXPECT_NE(problemOf({"--file", "x", "--bogus"}).find("'--bogus'"), std::string::npos);
  EXPECT_NE(problemOf({"--fil", "x"}).find("'--fil'"), std::string::npos);
  EXPECT_NE(problemOf({"--file", "x", "--file", "y"}).find("'--file'"), std::string::npos);
  EXPECT_NE(problemOf({"--file"}).find("'--file'"), std::string::npos);
}

TEST(CommandLine, helpsWithoutSettingAnything) {
  Values values;
  const auto help = read({"--help", "--trials", "7"}, &values);
  ASSERT_TRUE(help);
  EXPECT_EQ(values.trials, 3);
  EXPECT_EQ(help->find("Usage: program [OPTION ...]\n\nWhat it is for:\n"), 0U) << *help;
  EXPECT_NE(help->find("--trials 1..10 (=3)"), std::string::npos) << *help;
  EXPECT_EQ(help->find("(=0)"), std::string::npos) << *help;
}

}  // namespace
}  // namespace smore
