// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/parameters.h"

#include <cmath>
#include <sstream>

#include "core_schema.h"
#include "smore/common/result.h"

namespace smore {
namespace {

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string show(const YAML::Node& node) {
  return node.IsScalar() ? "'" + node.Scalar() + "'"
         : node.IsNull() ? "nothing"
                         : "a list or mapping";
}

std::string describe(const Range& range) {
  std::ostringstream text;
  text << "from " << range.min << " to " << range.max;
  return text.str();
}

bool readNumber(const YAML::Node& node, double* value) {
  const auto number = node.IsScalar() ? coreNumber(node.Scalar()) : std::nullopt;
  if (number) *value = *number;
  return number.has_value();
}

bool readVector(const YAML::Node& node, Vec3* value) {
  bool good = node.IsSequence() && node.size() == 3;
  for (int i = 0; good && i < 3; ++i) good = readNumber(node[i], &(*value)[i]);
  return good;
}

constexpr const char* kNoVector = "expected a list of three finite numbers [x, y, z]";

bool beyondFullTurn(double angle) { return std::abs(angle) > 2.0 * M_PI; }

std::string looksLikeDegrees(const YAML::Node& node) {
  return show(node) + " is beyond 2 pi; angles are in radians; " + node.Scalar() +
         " looks like degrees";
}

}  // namespace

ParameterReader::ParameterReader(const YAML::Node& mapping, const std::string& source)
    : ParameterReader(mapping, source, "", std::make_shared<std::vector<std::string>>()) {}

ParameterReader::ParameterReader(const YAML::Node& mapping, const std::string& source,
                                 const std::string& prefix,
                                 std::shared_ptr<std::vector<std::string>> errors)
    : mapping_(mapping), source_(source), prefix_(prefix), errors_(std::move(errors)) {
  if (!mapping_.IsMap()) {
    const std::string place = prefix.empty() ? "the file" : prefix.substr(0, prefix.size() - 1);
    errors_->push_back(source_ + ": " + place + ": expected a mapping 'key: value'");
    mapping_ = YAML::Node(YAML::NodeType::Map);
  }
}

YAML::Node ParameterReader::find(const std::string& key) {
  const bool given = has(key);
  const YAML::Node& readonly = mapping_;
  YAML::Node node = readonly[key];
  if (!given) error(key, "missing; add it");
  return node;
}

bool ParameterReader::has(const std::string& key) {
  known_.insert(key);
  const YAML::Node& readonly = mapping_;
  return readonly[key].IsDefined();
}

void ParameterReader::number(const std::string& key, double* value, Range range) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  double number = 0.0;
  if (!readNumber(node, &number)) {
    error(key, "expected a finite number, got " + show(node));
  } else if (number < range.min || number > range.max) {
    error(key, show(node) + " is out of range; use a number " + describe(range));
  } else {
    *value = number;
  }
}

void ParameterReader::integer(const std::string& key, int* value, int min, int max) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  const auto number = node.IsScalar() ? coreInteger(node.Scalar()) : std::nullopt;
  if (!number) {
    error(key, "expected a whole number, got " + show(node));
  } else if (*number < min || *number > max) {
    error(key, show(node) + " is out of range; use a whole number from " + std::to_string(min) +
                   " to " + std::to_string(max));
  } else {
    *value = static_cast<int>(*number);
  }
}

void ParameterReader::angle(const std::string& key, double* value, Range range) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  double angle = 0.0;
  if (!readNumber(node, &angle)) {
    error(key, "expected a finite number, got " + show(node));
  } else if (beyondFullTurn(angle)) {
    error(key, looksLikeDegrees(node));
  } else if (angle < range.min || angle > range.max) {
    error(key, show(node) + " is out of range; use a number " + describe(range));
  } else {
    *value = angle;
  }
}

void ParameterReader::angles(const std::string& key, Vec3* value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  Vec3 angles = Vec3::Zero();
  if (!readVector(node, &angles)) {
    error(key, kNoVector);
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (beyondFullTurn(angles[i])) return error(key, looksLikeDegrees(node[i]));
  }
  *value = angles;
}

void ParameterReader::boolean(const std::string& key, bool* value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  const auto given = node.IsScalar() ? coreBoolean(node.Scalar()) : std::nullopt;
  if (!given) {
    error(key, "expected true or false, got " + show(node));
  } else {
    *value = *given;
  }
}

void ParameterReader::text(const std::string& key, std::string* value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar() || node.Scalar().empty()) {
    error(key, "expected a text, got " + show(node));
  } else {
    *value = node.Scalar();
  }
}

void ParameterReader::choice(const std::string& key, const std::vector<std::string>& choices,
                             int* index) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  for (size_t i = 0; i < choices.size(); ++i) {
    if (node.IsScalar() && node.Scalar() == choices[i]) {
      *index = static_cast<int>(i);
      return;
    }
  }
  error(key, "expected one of " + join(choices, ", ") + ", got " + show(node));
}

void ParameterReader::vector(const std::string& key, Vec3* value, Range range) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  Vec3 vector = Vec3::Zero();
  if (!readVector(node, &vector)) {
    error(key, kNoVector);
  } else if (vector.minCoeff() < range.min || vector.maxCoeff() > range.max) {
    error(key, "out of range; use numbers " + describe(range));
  } else {
    *value = vector;
  }
}

ParameterReader ParameterReader::nested(const std::string& key) {
  const YAML::Node found = find(key);
  const YAML::Node node = found.IsDefined() ? found : YAML::Node(YAML::NodeType::Map);
  return ParameterReader(node, source_, prefix_ + key + ".", errors_);
}

std::vector<ParameterReader> ParameterReader::list(const std::string& key) {
  std::vector<ParameterReader> readers;
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return readers;
  if (!node.IsSequence() || node.size() == 0) {
    error(key, "expected a list with at least one entry");
    return readers;
  }
  for (size_t i = 0; i < node.size(); ++i) {
    const std::string prefix = prefix_ + key + "[" + std::to_string(i) + "].";
    readers.push_back(ParameterReader(node[i], source_, prefix, errors_));
  }
  return readers;
}

void ParameterReader::error(const std::string& key, const std::string& problem) {
  errors_->push_back(source_ + ": " + prefix_ + key + ": " + problem);
}

void ParameterReader::finishNested() {
  for (const auto& entry : mapping_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a text)";
    if (known_.count(key) > 0) continue;
    const std::vector<std::string> known(known_.begin(), known_.end());
    error(key, "unknown key; remove it or use one of: " + join(known, ", "));
  }
}

void ParameterReader::finish() {
  finishNested();
  if (!errors_->empty()) throw InputError(join(*errors_, "\n"));
}

}  // namespace smore
