// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace smore {

/// What is wrong with a file that will be written, for the user; empty if nothing is. Its
/// directory is made where it is missing. What the file holds stays. Recorded evidence and the
/// files in `inputs` (names of none, too) are not written over. Asked before hours of work, not
/// after.
std::string problemOfFile(const std::string& file, const std::vector<std::string>& inputs = {});

/// The same of a directory for maps (saveMaps), or for directories seed_N of maps: none of the
/// inputs may be one of them.
std::string problemOfMapsDirectory(const std::string& directory,
                                   const std::vector<std::string>& inputs);

}  // namespace smore
