// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace smore {

/// Bad input from a user: a file, a key, an argument. The message names the place, the value and
/// the remedy, and is all that the user needs to see.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Why an expected outcome did not come about, in words for the user.
struct Failure {
  std::string reason;
};

/// A value, or the reason why there is none. For outcomes that belong to normal operation (no line
/// in this wrench, no path to this goal); errors of a caller throw.
template <typename T>
class Result {
 public:
  Result(T value) : content_(std::move(value)) {}            // NOLINT(google-explicit-constructor)
  Result(Failure failure) : content_(std::move(failure)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return std::holds_alternative<T>(content_); }

  /// The value; std::bad_variant_access where there is none.
  const T& operator*() const { return std::get<T>(content_); }
  T& operator*() { return std::get<T>(content_); }
  const T* operator->() const { return &std::get<T>(content_); }
  T* operator->() { return &std::get<T>(content_); }

  /// The reason; std::bad_variant_access where there is a value.
  const std::string& reason() const { return std::get<Failure>(content_).reason; }

 private:
  std::variant<T, Failure> content_;
};

}  // namespace smore
