// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/json_fields.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What a method may know of a scenario, with every value, given or not.
Json taskRecord(const Scenario& scenario);

/// A scenario without shapes from such a record. InputError for missing or impossible values.
Scenario readTask(const JsonFields& record);

}  // namespace smore
