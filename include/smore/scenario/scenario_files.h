// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace smore {

/// The directory of the scenarios that come with the package: of the installed package where this
/// library is installed, of the source tree else.
std::string shippedScenarioDirectory();

/// The file that `name_or_path` means: itself if it is a readable file, else NAME.yaml in
/// `directory`. InputError where neither is: for a path (a text with '/' or the end '.yaml') it
/// says where it was looked for, for a name which names there are, for a directory that it is one.
std::string findScenario(const std::string& name_or_path, const std::string& directory);

}  // namespace smore
