// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace smore {

/// JSON whose objects keep the order of their keys.
using Json = nlohmann::ordered_json;

}  // namespace smore
