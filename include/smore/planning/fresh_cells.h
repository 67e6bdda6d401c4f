// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/worlds.h"

namespace smore {

/// The cells of poses that a motion enters for the first time. A cell counts once, however often
/// the motion comes back to it.
class FreshCells {
 public:
  /// Of a motion that nothing has been asked about yet; `worlds` must outlive it.
  explicit FreshCells(const Worlds& worlds)
      : worlds_(&worlds), entered_(worlds.free.parameters()) {}

  /// The next pose of the motion, which must be finite. Nothing is added where one in its cell was
  /// free or has been entered, else the share of the places around the pose at which something may
  /// touch that is not known beforehand.
  void enter(const Pose& T_world_object);

  /// What has been entered [cells].
  double count() const { return count_; }

 private:
  const Worlds* worlds_;
  FreeCells entered_;
  double count_ = 0.0;
};

}  // namespace smore
