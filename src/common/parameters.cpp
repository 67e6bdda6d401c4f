// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/parameters.h"

#include <cmath>
#include <fstream>
#include <sstream>

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

bool readFinite(const YAML::Node& node, double* value) {
  return node.IsScalar() && YAML::convert<double>::decode(node, *value) && std::isfinite(*value);
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
  known_.insert(key);
  const YAML::Node& readonly = mapping_;
  YAML::Node node = readonly[key];
  if (!node.IsDefined()) error(key, "missing; add it");
  return node;
}

bool ParameterReader::has(const std::string& key) const { return mapping_[key].IsDefined(); }

void ParameterReader::number(const std::string& key, double* value, Range range) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  double number = 0.0;
  if (!readFinite(node, &number)) {
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
  int number = 0;
  if (!node.IsScalar() || !YAML::convert<int>::decode(node, number)) {
    error(key, "expected a whole number, got " + show(node));
  } else if (number < min || number > max) {
    error(key, show(node) + " is out of range; use a whole number from " + std::to_string(min) +
                   " to " + std::to_string(max));
  } else {
    *value = number;
  }
}

void ParameterReader::boolean(const std::string& key, bool* value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar() || !YAML::convert<bool>::decode(node, *value)) {
    error(key, "expected true or false, got " + show(node));
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
  bool good = node.IsSequence() && node.size() == 3;
  for (int i = 0; good && i < 3; ++i) good = readFinite(node[i], &vector[i]);
  if (!good) {
    error(key, "expected a list of three finite numbers [x, y, z]");
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

YAML::Node loadYaml(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": cannot be read; check the path and the permissions");
  try {
    return YAML::Load(stream);
  } catch (const YAML::Exception& error) {
    throw InputError(file + ": line " + std::to_string(error.mark.line + 1) +
                     ": not valid YAML: " + error.msg);
  }
}

}  // namespace smore
