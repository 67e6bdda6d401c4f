// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace smore {

/// JSON whose objects sort their keys: nlohmann of before 3.9 keeps no other order.
using Json = nlohmann::json;

}  // namespace smore
