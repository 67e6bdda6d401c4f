// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/contact_hypotheses.h"

namespace smore {

/// A contact with one place on the object and one in the world, without normals.
inline ContactHypotheses contactAt(const Vec3& object, const Vec3& world, std::uint64_t id) {
  ContactHypotheses contact;
  contact.count = 1;
  contact.object.set(0, object);
  contact.world.set(0, world);
  contact.id = id;
  return contact;
}

}  // namespace smore
