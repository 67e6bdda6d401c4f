// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace smore {

/// What is wrong with a file that will be written, for the user; empty if nothing is. It and
/// its directory are made where they are missing. What it holds stays. Recorded evidence and the
/// files in `inputs` (names of none, too) are not written over. Asked before hours of work, not
/// after.
std::string problemOfFile(const std::string& file, const std::vector<std::string>& inputs = {});

/// The same of a directory for maps, and for directories of maps in it (saveMaps): an octree with
/// the name of one of theirs that is among the inputs must not lie in it.
std::string problemOfMapsDirectory(const std::string& directory,
                                   const std::vector<std::string>& inputs);

}  // namespace smore
