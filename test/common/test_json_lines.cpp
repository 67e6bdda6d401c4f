// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "../scenario/temporary_directory.h"
#include "refusal.h"
#include "smore/common/json_fields.h"
#include "smore/common/json_lines.h"
#include "smore/common/result.h"

namespace smore {
namespace {

bool says(const std::string& message, const std::string& words) {
  return message.find(words) != std::string::npos;
}

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

std::vector<Json> recordsOf(const std::string& file, bool* whole = nullptr) {
  std::vector<Json> records;
  const bool all = readJsonLines(
      file, [&records](int /*line*/, const Json& record) { records.push_back(record); });
  if (whole != nullptr) *whole = all;
  return records;
}

std::string problemOf(const std::string& file) {
  return refusalOf([&] { return recordsOf(file); });
}

class JsonLines : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
};

TEST_F(JsonLines, keepEveryBitOfANumber) {
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 0.1,
                                 1.0 / 3.0,
                                 Limits::max(),
                                 Limits::min(),
                                 Limits::denorm_min(),
                                 Limits::lowest(),
                                 1.0 + Limits::epsilon(),
                                 5e-324,
                                 1e23};
  std::mt19937_64 random(1);
  while (numbers.size() < 20000) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value)) numbers.push_back(value);
  }
  const std::string file = directory_.path() + "/numbers";
  JsonLinesWriter writer(file);
  for (const double number : numbers) writer.append({{"number", number}});
  const auto records = recordsOf(file);
  ASSERT_EQ(records.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(bitsOf(records[i]["number"].get<double>()), bitsOf(numbers[i])) << numbers[i];
  }
}

TEST_F(JsonLines, areReadableWhileTheWriterIsStillOpen) {
  const std::string file = directory_.path() + "/open";
  JsonLinesWriter writer(file);
  for (int i = 0; i < 5; ++i) {
    writer.append({{"i", i}});
    EXPECT_EQ(recordsOf(file).size(), static_cast<std::size_t>(i + 1));
  }
}

TEST_F(JsonLines, leaveOutALastLineWithoutItsEnd) {
  bool whole = true;
  const auto records =
      recordsOf(directory_.write("cut", "{\"a\":1}\n{\"a\":2}\n{\"a\":3}"), &whole);
  EXPECT_EQ(records.size(), 2u) << "even if it happens to be JSON: a digit may be missing";
  EXPECT_FALSE(whole);
  EXPECT_TRUE(recordsOf(directory_.write("empty", ""), &whole).empty());
  EXPECT_TRUE(whole);
}

TEST_F(JsonLines, nameTheLineThatIsNoRecord) {
  for (const std::string damaged : {"", "[1, 2]", "{\"a\":nan}", "{\"a\":1e999}", "{\"a\":1}}",
                                    "\xff\xfe", "{\"a\":\"\xc3\"}"}) {
    const std::string file = directory_.write("damaged", "{\"a\":1}\n" + damaged + "\n{\"a\":2}\n");
    EXPECT_PRED2(says, problemOf(file), "line 2: not a record") << damaged;
  }
}

TEST_F(JsonLines, sayWhatCannotBeReadOrWritten) {
  EXPECT_PRED2(says, problemOf("/nowhere/file"), "/nowhere/file: cannot be read");
  EXPECT_PRED2(says, problemOf(directory_.path()), "cannot be read");
  EXPECT_THROW(JsonLinesWriter("/nowhere/file"), std::runtime_error);
  JsonLinesWriter full("/dev/full");
  EXPECT_THROW(full.append({{"a", 1}}), std::runtime_error);
}

TEST(JsonFields, readAPoseBitByBit) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    Pose pose = Pose::Identity();
    pose.linear() =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    pose.translation() = Vec3(normal(random), 1e-12 * normal(random), 1e3 * normal(random));
    const Json record = Json::parse(Json{{"pose", toJson(pose)}}.dump());
    EXPECT_EQ(JsonFields(record, "here").pose("pose").matrix(), pose.matrix());
  }
}

std::string complaint(const std::string& text, const std::function<void(const JsonFields&)>& read) {
  const Json record = Json::parse(text);
  try {
    read(JsonFields(record, "here"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonFields, refuseWhatIsNoRigidPose) {
  const auto read = [](const JsonFields& fields) { fields.pose("p"); };
  EXPECT_EQ(complaint(R"({"p":[1,0,0,0, 0,1,0,0, 0,0,1,0]})", read), "");
  for (const char* text :
       {R"({"p":[1,0,0,0, 0,1,0,0, 0,0,1]})", R"({"p":[1,0,0,0, 0,1,0,0, 0,0,-1,0]})",
        R"({"p":[1,0,0,0, 0,1.001,0,0, 0,0,1,0]})", R"({"p":[null,0,0,0, 0,1,0,0, 0,0,1,0]})",
        R"({"p":"1"})", R"({"p":[1,0,0,"0", 0,1,0,0, 0,0,1,0]})"}) {
    EXPECT_PRED2(says, complaint(text, read), "here: p: expected 12 numbers") << text;
  }
  EXPECT_PRED2(says, complaint("{}", read), "here: p: missing");
}

TEST(JsonFields, refuseValuesOfAnotherKind) {
  const auto number = [](const JsonFields& fields) { fields.number("a", {0.0, 1.0}); };
  const auto integer = [](const JsonFields& fields) { fields.integer("a", 0, 10); };
  const auto choice = [](const JsonFields& fields) { fields.choice("a", {"x", "y"}); };
  EXPECT_EQ(complaint(R"({"a":0.5})", number), "");
  EXPECT_EQ(complaint(R"({"a":5})", integer), "");
  EXPECT_EQ(complaint(R"({"a":"y"})", choice), "");
  for (const char* text : {R"({"a":"0.5"})", R"({"a":2})", R"({"a":null})", R"({"a":[0.5]})"}) {
    EXPECT_PRED2(says, complaint(text, number), "here: a: ") << text;
  }
  for (const char* text : {R"({"a":0.5})", R"({"a":11})", R"({"a":1e300})", R"({"a":99999999999})",
                           R"({"a":18446744073709551615})", R"({"a":-1})"}) {
    EXPECT_PRED2(says, complaint(text, integer), "here: a: ") << text;
  }
  EXPECT_PRED2(says, complaint(R"({"a":"z"})", choice), "one of x, y, got 'z'");
  EXPECT_PRED2(says, complaint(R"({"a":-1})", [](const JsonFields& fields) { fields.count("a"); }),
               "here: a: ");
}

}  // namespace
}  // namespace smore
