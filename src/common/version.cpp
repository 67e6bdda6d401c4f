// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/version.h"

namespace smore {

const char* programVersion() { return SMORE_VERSION; }

}  // namespace smore
