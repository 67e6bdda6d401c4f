// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "refusal.h"
#include "smore/common/parameters.h"
#include "smore/common/result.h"
#include "smore/common/yaml_file.h"

namespace smore {
namespace {

class LoadYaml : public testing::Test {
 protected:
  ~LoadYaml() override { std::remove(file_.c_str()); }

  YAML::Node load(const std::string& content) {
    std::ofstream(file_, std::ios::binary) << content;
    return loadYaml(file_);
  }

  std::string problemOf(const std::string& content) {
    return refusalOf([&] { return load(content); });
  }

  void expectProblem(const std::string& content, const std::string& part) {
    const std::string problem = problemOf(content);
    EXPECT_NE(problem.find(part), std::string::npos) << "expected '" << part << "' in: " << problem;
    EXPECT_EQ(problem.find(file_), 0u) << problem;
  }

  const std::string file_ = testing::TempDir() + "smore_" +
                            testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml";
};

TEST_F(LoadYaml, namesWhatCannotBeRead) {
  EXPECT_THROW(loadYaml("/nowhere/file.yaml"), InputError);
  try {
    loadYaml(testing::TempDir());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is a directory"), std::string::npos);
  }
}

TEST_F(LoadYaml, takesUtf8WithMarkAndCarriageReturns) {
  EXPECT_EQ(load("\xEF\xBB\xBFname: St\xC3\xBC"
                 "ck\r\nb: 1\r\n")["name"]
                .Scalar(),
            "St\xC3\xBC"
            "ck");
  EXPECT_EQ(load("a: \xF0\x9F\xA4\x96")["a"].Scalar(), "\xF0\x9F\xA4\x96");
}

TEST_F(LoadYaml, refusesOtherEncodingsWithTheirLine) {
  expectProblem(
      "a: 1\nb: St\xFC"
      "ck\n",
      "line 2: not UTF-8 (byte 252)");
  expectProblem("a: \xC0\xAF", "not UTF-8");          // overlong
  expectProblem("a: \xED\xA0\x80", "not UTF-8");      // a surrogate
  expectProblem("a: \xF4\x90\x80\x80", "not UTF-8");  // beyond U+10FFFF
  expectProblem("a: \xE2\x82", "not UTF-8");          // cut short
  expectProblem(std::string("\xFF\xFE"
                            "a\0",
                            4),
                "UTF-16");
  expectProblem(std::string("a\0:\0", 4), "UTF-16");
}

TEST_F(LoadYaml, refusesASecondDocument) {
  expectProblem("a: 1\n---\nb: 2\n", "a second document");
  EXPECT_EQ(load("---\na: 1\n...\n")["a"].Scalar(), "1");
}

TEST_F(LoadYaml, refusesAKeyThatStandsTwiceAtAnyDepth) {
  expectProblem("a: 1\nb: 2\na: 3\n", "line 3: the key 'a' is given twice");
  expectProblem("a:\n  - {b: 1}\n  - {c: 1, c: 2}\n", "line 3: the key 'c' is given twice");
  EXPECT_EQ(problemOf("a: {c: 1}\nb: {c: 1}\n"), "");
}

TEST_F(LoadYaml, refusesAnAliasIntoItself) {
  expectProblem("a: &x {b: *x}\n", "nested too deeply");
}

TEST_F(LoadYaml, tellsTheLineOfMalformedText) { expectProblem("a: 1\nb: [\n", "not valid YAML"); }

// Expected values by YAML 1.2.2, chapter 10.3.
TEST_F(LoadYaml, numbersAreThoseOfTheCoreSchema) {
  const std::vector<std::pair<std::string, double>> numbers{
      {"0010", 10.0}, {"1e-3", 0.001}, {"-.5", -0.5}, {"3e-2", 0.03},   {"+1.", 1.0},
      {"0o10", 8.0},  {"0x1F", 31.0},  {"-0", 0.0},   {"1.5E+2", 150.0}};
  for (const auto& [text, expected] : numbers) {
    ParameterReader reader(load("a: " + text), "f");
    double value = -1.0;
    reader.number("a", &value);
    EXPECT_NO_THROW(reader.finish()) << text;
    EXPECT_EQ(value, expected) << text;
  }
  for (const char* text :
       {"1_000", "0b11", "1e", "e3", ".", "1,5", ".inf", "1e999", "0x", "12:30"}) {
    ParameterReader reader(load(std::string("a: '") + text + "'"), "f");
    double value = -1.0;
    reader.number("a", &value);
    EXPECT_THROW(reader.finish(), InputError) << text;
  }
}

TEST_F(LoadYaml, wholeNumbersAndTruthAreThoseOfTheCoreSchema) {
  ParameterReader reader(load("{a: 0010, b: 0x10, c: True, d: 007}"), "f");
  int a = 0;
  int b = 0;
  bool c = false;
  std::string d;
  reader.integer("a", &a, 0, 100);
  reader.integer("b", &b, 0, 100);
  reader.boolean("c", &c);
  reader.text("d", &d);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(a, 10);
  EXPECT_EQ(b, 16);
  EXPECT_TRUE(c);
  EXPECT_EQ(d, "007");
  ParameterReader yes(load("a: yes"), "f");
  yes.boolean("a", &c);
  EXPECT_THROW(yes.finish(), InputError);
}

TEST_F(LoadYaml, anglesBeyondAFullTurnAreTakenForDegrees) {
  ParameterReader reader(load("{a: 6.28, b: [0, -90, 0], c: 30}"), "f");
  double angle = 0.0;
  Vec3 angles = Vec3::Zero();
  reader.angle("a", &angle);
  reader.angles("b", &angles);
  reader.angle("c", &angle, {0.0, 1.0});
  EXPECT_EQ(angle, 6.28);
  EXPECT_EQ(angles, Vec3::Zero());
  try {
    reader.finish();
    FAIL();
  } catch (const InputError& error) {
    const std::string problem = error.what();
    EXPECT_NE(problem.find("f: b: '-90' is beyond 2 pi; angles are in radians; -90 looks like"),
              std::string::npos)
        << problem;
    EXPECT_NE(problem.find("f: c: '30' is beyond 2 pi"), std::string::npos) << problem;
  }
}

TEST_F(LoadYaml, anUnknownKeyNamesAllKeysThatExist) {
  ParameterReader reader(load("{given: 1, stray: 2}"), "f");
  double value = 0.0;
  for (const char* key : {"given", "optional"}) {
    if (reader.has(key)) reader.number(key, &value);
  }
  try {
    reader.finish();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f: stray: unknown key; remove it or use one of: given, optional");
  }
}

}  // namespace
}  // namespace smore
