// SPDX-License-Identifier: BSD-3-Clause
#include "core_schema.h"

#include <cmath>
#include <locale>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace smore {
namespace {

std::optional<long long> inBase(const std::string& digits, int base) {
  try {
    return std::stoll(digits, nullptr, base);
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<double> coreNumber(const std::string& scalar) {
  static const std::regex decimal(R"([-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?)");
  if (!std::regex_match(scalar, decimal)) {
    const std::optional<long long> integer = coreInteger(scalar);  // hexadecimal or octal
    return integer ? std::optional<double>(static_cast<double>(*integer)) : std::nullopt;
  }
  std::istringstream stream(scalar);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long long> coreInteger(const std::string& scalar) {
  static const std::regex decimal("[-+]?[0-9]+");
  static const std::regex octal("0o[0-7]+");
  static const std::regex hexadecimal("0x[0-9a-fA-F]+");
  if (std::regex_match(scalar, decimal)) return inBase(scalar, 10);
  if (std::regex_match(scalar, octal)) return inBase(scalar.substr(2), 8);
  if (std::regex_match(scalar, hexadecimal)) return inBase(scalar.substr(2), 16);
  return std::nullopt;
}

std::optional<bool> coreBoolean(const std::string& scalar) {
  if (scalar == "true" || scalar == "True" || scalar == "TRUE") return true;
  if (scalar == "false" || scalar == "False" || scalar == "FALSE") return false;
  return std::nullopt;
}

}  // namespace smore
