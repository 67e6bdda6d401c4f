// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/json.h"
#include "smore/common/parameters.h"

namespace smore {

/// [x, y, z].
Json toJson(const Vec3& vector);

/// The upper three rows of the 4 x 4 matrix, one after the other: 12 numbers, from which the same
/// pose is read bit by bit.
Json toJson(const Pose& pose);

/// Typed values of a record that was read. Each accessor throws InputError, with the place of the
/// record, the key, and what was expected, where the key is missing or its value is another.
class JsonFields {
 public:
  /// `object` must outlive this; `place` names it in messages ("FILE: line 3").
  JsonFields(const Json& object, std::string place);

  bool has(const std::string& key) const;

  /// Finite.
  double number(const std::string& key, Range range = {}) const;
  int integer(const std::string& key, int min, int max) const;
  std::uint64_t count(const std::string& key) const;
  bool boolean(const std::string& key) const;
  std::string text(const std::string& key) const;
  /// Position in `choices` of a text.
  int choice(const std::string& key, const std::vector<std::string>& choices) const;
  Vec3 vector(const std::string& key) const;
  std::vector<Vec3> vectors(const std::string& key) const;
  /// Rigid to 1e-6.
  Pose pose(const std::string& key) const;
  Path path(const std::string& key) const;

  JsonFields object(const std::string& key) const;
  /// A list of objects.
  std::vector<JsonFields> list(const std::string& key) const;

  /// The value itself; null where the key is missing.
  const Json& raw(const std::string& key) const;

  /// Throws InputError: "PLACE: KEY: PROBLEM".
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

 private:
  const Json& at(const std::string& key) const;
  const Json& listAt(const std::string& key) const;
  Vec3 vectorOf(const std::string& key, const Json& numbers) const;
  Pose poseOf(const std::string& key, const Json& numbers) const;

  const Json* object_;
  std::string place_;
};

}  // namespace smore
