// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace smore {

/// What is wrong with a directory that will be written to, for the user; empty if nothing is. It is
/// made where it is missing, with those that it lies in. Asked before hours of work, not after.
std::string problemOfDirectory(const std::string& directory);

/// The same for a file, which is made where it is missing. What it holds stays. Recorded evidence
/// and the files in `inputs` (names of none, too) are not written over.
std::string problemOfFile(const std::string& file, const std::vector<std::string>& inputs = {});

}  // namespace smore
