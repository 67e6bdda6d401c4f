// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/parameters.h"
#include "smore/scenario/prior_source.h"

namespace smore {

/// Reads the key `prior` where it is given; files relative to `directory`, which ends with a slash
/// or is empty. Notes what is wrong with the keys; what is in the files is checked when it is used.
PriorSources readPriorSources(ParameterReader* reader, const std::string& directory);

}  // namespace smore
