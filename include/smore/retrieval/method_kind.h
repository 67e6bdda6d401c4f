// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace smore {

enum class MethodKind {
  kPaper,    ///< the laws in sequence; RRT (space: RRT-Connect) around voxels with P >= 0.5
  kCspace,   ///< the paper's baseline: RRT around the poses of known contacts; no use of the maps
  kSmore,    ///< the best that this project can do
  kBlocked,  ///< probabilities of configurations from blocked movements (Pajarinen et al., 2020)
  kChs,      ///< told the object's shape: collision hypothesis sets (Saund and Berenson, 2018)
};

/// Kind of a name, one of methodNames(); InputError for any other.
MethodKind methodKind(const std::string& name);
std::string methodName(MethodKind kind);

/// Names of all kinds, in the order of MethodKind.
std::vector<std::string> methodNames();

}  // namespace smore
