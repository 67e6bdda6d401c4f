// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace smore {

/// What is wrong with a directory that will be written to, for the user; empty if nothing is. It is
/// made where it is missing, with those that it lies in. Asked before hours of work, or before a
/// robot moves, not after.
std::string problemOfDirectory(const std::string& directory);

}  // namespace smore
