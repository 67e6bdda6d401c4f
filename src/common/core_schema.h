// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace smore {

/// Plain scalars as the core schema of YAML 1.2 reads them (section 10.3): 0010 is ten, 0o10 eight,
/// 1e-3 and -.5 are numbers, `yes` is a text. Whatever the locale. Nothing for any other text.
std::optional<double> coreNumber(const std::string& scalar);  ///< finite
std::optional<long long> coreInteger(const std::string& scalar);
std::optional<bool> coreBoolean(const std::string& scalar);

}  // namespace smore
