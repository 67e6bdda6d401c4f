// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace octomap {
class OcTree;
}

namespace smore {

/// Reads a file of an OctoMap of occupancies, .bt or .ot. InputError with file and remedy: it is of
/// another kind, empty, cut or damaged.
std::unique_ptr<octomap::OcTree> readOctree(const std::string& file);

}  // namespace smore
