// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/json_fields.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "smore/common/result.h"

namespace smore {
namespace {

constexpr int kPoseRows = 3;
constexpr int kPoseColumns = 4;

// Rotations that were multiplied many times are orthogonal to about 1e-12; a damaged digit is not.
constexpr double kRigid = 1e-6;

bool isListOfNumbers(const Json& value, std::size_t count) {
  return value.is_array() && value.size() == count &&
         std::all_of(value.begin(), value.end(), [](const Json& element) {
           return element.is_number() && std::isfinite(element.get<double>());
         });
}

bool isRigid(const Pose& pose) {
  const Eigen::Matrix3d rotation = pose.linear();
  return (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() <= kRigid &&
         rotation.determinant() > 0.0;
}

}  // namespace

Json toJson(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json toJson(const Pose& pose) {
  Json numbers = Json::array();
  for (int row = 0; row < kPoseRows; ++row) {
    for (int column = 0; column < kPoseColumns; ++column) {
      numbers.push_back(pose.matrix()(row, column));
    }
  }
  return numbers;
}

JsonFields::JsonFields(const Json& object, std::string place)
    : object_(&object), place_(std::move(place)) {}

bool JsonFields::has(const std::string& key) const { return object_->contains(key); }

void JsonFields::fail(const std::string& key, const std::string& problem) const {
  throw InputError(place_ + ": " + key + ": " + problem);
}

const Json& JsonFields::raw(const std::string& key) const {
  static const Json null;
  const auto found = object_->find(key);
  return found == object_->end() ? null : *found;
}

const Json& JsonFields::at(const std::string& key) const {
  if (!has(key)) fail(key, "missing; the record is damaged");
  return raw(key);
}

const Json& JsonFields::listAt(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_array()) fail(key, "expected a list");
  return value;
}

double JsonFields::number(const std::string& key, Range range) const {
  const Json& value = at(key);
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    fail(key, "expected a finite number, got " + value.dump());
  }
  const auto number = value.get<double>();
  if (number < range.min || number > range.max) {
    std::ostringstream problem;
    problem << value.dump() << " is out of range; expected a number from " << range.min << " to "
            << range.max;
    fail(key, problem.str());
  }
  return number;
}

int JsonFields::integer(const std::string& key, int min, int max) const {
  const Json& value = at(key);
  const bool is_small =
      value.is_number_integer() && std::abs(value.get<double>()) <= std::numeric_limits<int>::max();
  if (!is_small || value.get<int>() < min || value.get<int>() > max) {
    fail(key, "expected a whole number from " + std::to_string(min) + " to " + std::to_string(max) +
                  ", got " + value.dump());
  }
  return value.get<int>();
}

std::uint64_t JsonFields::count(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_number_unsigned()) {
    fail(key, "expected a whole number that is not negative, got " + value.dump());
  }
  return value.get<std::uint64_t>();
}

bool JsonFields::boolean(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_boolean()) fail(key, "expected true or false, got " + value.dump());
  return value.get<bool>();
}

std::string JsonFields::text(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_string()) fail(key, "expected a text, got " + value.dump());
  return value.get<std::string>();
}

int JsonFields::choice(const std::string& key, const std::vector<std::string>& choices) const {
  const std::string value = text(key);
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found != choices.end()) return static_cast<int>(found - choices.begin());
  std::string known;
  for (const std::string& name : choices) known += (known.empty() ? "" : ", ") + name;
  fail(key, "expected one of " + known + ", got '" + value + "'");
}

Vec3 JsonFields::vectorOf(const std::string& key, const Json& numbers) const {
  if (!isListOfNumbers(numbers, 3)) fail(key, "expected three finite numbers");
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

Vec3 JsonFields::vector(const std::string& key) const { return vectorOf(key, at(key)); }

std::vector<Vec3> JsonFields::vectors(const std::string& key) const {
  std::vector<Vec3> vectors;
  for (const Json& numbers : listAt(key)) vectors.push_back(vectorOf(key, numbers));
  return vectors;
}

Pose JsonFields::poseOf(const std::string& key, const Json& numbers) const {
  Pose pose = Pose::Identity();
  if (isListOfNumbers(numbers, kPoseRows * kPoseColumns)) {
    for (int i = 0; i < kPoseRows * kPoseColumns; ++i) {
      pose.matrix()(i / kPoseColumns, i % kPoseColumns) = numbers[i].get<double>();
    }
    if (isRigid(pose)) return pose;
  }
  fail(key, "expected 12 numbers that make a pose (the upper rows of a rigid transform's matrix)");
}

Pose JsonFields::pose(const std::string& key) const { return poseOf(key, at(key)); }

Path JsonFields::path(const std::string& key) const {
  Path path;
  for (const Json& numbers : listAt(key)) path.push_back(poseOf(key, numbers));
  return path;
}

JsonFields JsonFields::object(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_object()) fail(key, "expected an object");
  return {value, place_ + ": " + key};
}

std::vector<JsonFields> JsonFields::list(const std::string& key) const {
  std::vector<JsonFields> fields;
  for (const Json& element : listAt(key)) {
    if (!element.is_object()) fail(key, "expected a list of objects");
    fields.emplace_back(element, place_ + ": " + key);
  }
  return fields;
}

}  // namespace smore
