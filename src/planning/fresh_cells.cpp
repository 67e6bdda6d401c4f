// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/fresh_cells.h"

namespace smore {

void FreshCells::enter(const Pose& T_world_object) {
  const Pose T_map_object = worlds_->frame.toMap(T_world_object);
  if (worlds_->free.knows(T_map_object) || !entered_.add(T_map_object)) return;
  count_ += worlds_->sampled.unknownShareAt(T_map_object.cast<float>());
}

}  // namespace smore
