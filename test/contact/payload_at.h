// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/contact/payload.h"

namespace smore {

/// A payload of `mass` [kg] with its centre of mass at `center_object` in the object frame [m].
inline Payload payloadAt(double mass, const Vec3& center_object) {
  return {mass, mass * center_object};
}

}  // namespace smore
