// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/result.h"

namespace smore {

/// One edge of a search tree, by the positions of the object frame's origin in the world [m].
struct TreeEdge {
  Vec3 from;
  Vec3 to;
};

struct Plan {
  Path path;                        ///< from the start to within the goal's tolerance
  double risk = 0.0;                ///< probability that the motion touches, as far as is known
  std::vector<TreeEdge> tree = {};  ///< what the search explored, for display; see keepTree
};

/// Finds a motion by what has been learnt so far.
class Planner {
 public:
  virtual ~Planner() = default;

  /// A path from `start` to `goal` (T_world_object), or the reason why there is none.
  virtual Result<Plan> plan(const Pose& start, const Pose& goal) = 0;

  /// For when `plan` finds none although the object is known to have a way out: a path that passes
  /// what is least certainly occupied. Planners without such a notion fail with a reason.
  virtual Result<Plan> planRelaxed(const Pose& /*start*/, const Pose& /*goal*/) {
    return Failure{"this planner knows no path that is less certain"};
  }

  /// Places (T_world_object) where the robot cannot be on a way from where it stands: the next
  /// plans pass beside them, if there is another way. None at first. A planner that finds other
  /// paths at each call need not heed them.
  void avoid(std::vector<Pose> refused) { refused_ = std::move(refused); }

  /// Why the last plan could not be asked for, in words for the user; empty where it was searched
  /// for, found or not.
  virtual std::string outage() const { return ""; }

  /// Whether plans carry the tree of their search, which takes time. They do not at first.
  void keepTree(bool keep) { keep_tree_ = keep; }

 protected:
  std::vector<Pose> refused_;
  bool keep_tree_ = false;
};

}  // namespace smore
