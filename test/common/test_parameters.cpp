// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "smore/common/parameters.h"
#include "smore/common/result.h"

namespace smore {
namespace {

std::string problemsOf(const std::function<void(ParameterReader*)>& read, const std::string& yaml) {
  ParameterReader reader(YAML::Load(yaml), "file.yaml");
  try {
    read(&reader);
    reader.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterReader, readsEachType) {
  ParameterReader reader(
      YAML::Load("{a: 1.5, b: 3, c: true, d: word, e: left, f: [1, 2, 3], g: {h: 2}}"),
      "file.yaml");
  double a = 0.0;
  int b = 0;
  bool c = false;
  std::string d;
  int e = -1;
  Vec3 f = Vec3::Zero();
  double h = 0.0;
  reader.number("a", &a);
  reader.integer("b", &b, 0, 10);
  reader.boolean("c", &c);
  reader.text("d", &d);
  reader.choice("e", {"right", "left"}, &e);
  reader.vector("f", &f);
  ParameterReader nested = reader.nested("g");
  nested.number("h", &h);
  nested.finishNested();
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(a, 1.5);
  EXPECT_EQ(b, 3);
  EXPECT_TRUE(c);
  EXPECT_EQ(d, "word");
  EXPECT_EQ(e, 1);
  EXPECT_EQ(f, Vec3(1, 2, 3));
  EXPECT_EQ(h, 2.0);
}

TEST(ParameterReader, tellsAllProblemsAtOnceWithFileAndKey) {
  double number = 7.0;
  int integer = 7;
  const std::string problems = problemsOf(
      [&](ParameterReader* reader) {
        reader->number("missing", &number);
        reader->number("text", &number);
        reader->number("nan", &number);
        reader->number("big", &number, {0.0, 1.0});
        reader->integer("half", &integer, 0, 10);
        ParameterReader nested = reader->nested("inner");
        nested.finishNested();
      },
      "{text: word, nan: .nan, big: 2, half: 0.5, inner: {stray: 1}, unknown: 1}");
  for (const char* part :
       {"file.yaml: missing: missing", "file.yaml: text: expected a finite number, got 'word'",
        "file.yaml: nan: expected a finite number", "file.yaml: big: '2' is out of range",
        "file.yaml: half: expected a whole number", "file.yaml: inner.stray: unknown key",
        "file.yaml: unknown: unknown key"}) {
    EXPECT_NE(problems.find(part), std::string::npos) << part << "\nnot in\n" << problems;
  }
  EXPECT_EQ(number, 7.0);
  EXPECT_EQ(integer, 7);
}

TEST(ParameterReader, refusesAFileThatIsNoMapping) {
  EXPECT_NE(problemsOf([](ParameterReader*) {}, "[1, 2]").find("expected a mapping"),
            std::string::npos);
  EXPECT_NE(problemsOf([](ParameterReader*) {}, "").find("expected a mapping"), std::string::npos);
}

}  // namespace
}  // namespace smore
