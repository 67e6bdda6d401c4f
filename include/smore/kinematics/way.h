// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// By what a motion of an arm is judged before it begins.
enum class Way {
  kNew,   ///< it keeps away from its joints' limits, from singularities and from its own links
  kBack,  ///< it has come this way: as long as no joint passes its limit it can go back
};

}  // namespace smore
