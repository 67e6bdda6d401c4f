// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/result.h"

namespace smore {

/// The message of the InputError with which `action` refuses its input; empty where it takes it.
template <typename Action>
std::string refusalOf(Action&& action) {
  try {
    (void)action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace smore
