// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace smore {

/// Parses the one document of a YAML file in UTF-8 (a byte order mark and CRLF are fine).
/// InputError with file, line and remedy: what cannot be read or is a directory, other encodings,
/// malformed YAML, a second document, a key that stands twice in one mapping.
YAML::Node loadYaml(const std::string& file);

}  // namespace smore
