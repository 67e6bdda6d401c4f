// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Closed interval of valid values.
struct Range {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
};

/// Reads typed values from a YAML mapping and keeps a list of everything that is wrong, so that a
/// user sees all errors at once. Each reader call marks its key as known; `finish` reports every
/// key that nobody asked for and throws if there was any error.
///
/// Scalars are those of YAML 1.2's core schema. Values are finite; numbers outside their range,
/// values of a wrong type, unknown and missing keys are errors that name file, key, value and
/// remedy. After an error the target keeps its value.
class ParameterReader {
 public:
  /// `source` names the file or the node in messages. A node that is not a mapping is an error.
  ParameterReader(const YAML::Node& mapping, const std::string& source);

  /// Required keys: missing is an error.
  void number(const std::string& key, double* value, Range range = {});
  /// Angles [rad] of a full turn at most, so that degrees are told.
  void angle(const std::string& key, double* value, Range range = {});
  void angles(const std::string& key, Vec3* value);
  void integer(const std::string& key, int* value, int min, int max);
  void boolean(const std::string& key, bool* value);
  void text(const std::string& key, std::string* value);
  /// One of `choices`; the index of the choice is written.
  void choice(const std::string& key, const std::vector<std::string>& choices, int* index);
  void vector(const std::string& key, Vec3* value, Range range = {});

  /// Whether the key is given. Marks it as known.
  bool has(const std::string& key);

  /// Reader of a nested mapping (an empty one if the key is missing, after noting the error). It
  /// shares this reader's list of errors; its unknown keys are reported by its own `finishNested`.
  ParameterReader nested(const std::string& key);
  /// Readers of a list of mappings; a missing key or anything but a non-empty list is an error.
  std::vector<ParameterReader> list(const std::string& key);

  /// Notes an error of the caller's own about `key`: "FILE: KEY: PROBLEM".
  void error(const std::string& key, const std::string& problem);

  /// Reports unknown keys of this mapping to the shared list.
  void finishNested();
  /// finishNested, then throws InputError with all errors, one a line, if there are any.
  void finish();

 private:
  ParameterReader(const YAML::Node& mapping, const std::string& source, const std::string& prefix,
                  std::shared_ptr<std::vector<std::string>> errors);
  YAML::Node find(const std::string& key);

  YAML::Node mapping_;
  std::string source_;
  std::string prefix_;
  std::set<std::string> known_;
  std::shared_ptr<std::vector<std::string>> errors_;
};

}  // namespace smore
