// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smore/retrieval/evidence.h"

namespace smore {

/// What is taken instead of what a bag says, or where it does not say it.
struct BagChoices {
  std::optional<std::string> scenario;         ///< name or path of a scenario or task
  std::optional<MethodParameters> parameters;  ///< of the method
};

/// The evidence of a bag, and why its maps may not be those of the running system.
struct BagEvidence {
  Evidence evidence;
  std::vector<std::string> warnings;
};

/// Puts the wrenches and transforms of a bag through the whole contact sensing, and takes what a
/// mapping node would take of the observations. InputError with file and remedy: a bag that cannot
/// be read, without wrenches or transforms, of more than one sensor, or that does not say its task
/// where none is chosen.
BagEvidence readBag(const std::string& file, const BagChoices& choices);

}  // namespace smore
