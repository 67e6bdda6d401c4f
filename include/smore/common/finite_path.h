// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// InputError, with the remedy, where a pose that is commanded has a value that is not finite.
void requireFinite(const Path& path);

}  // namespace smore
