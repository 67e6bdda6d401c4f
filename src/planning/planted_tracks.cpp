// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/planted_tracks.h"

namespace smore {

void plantTracks(const std::vector<Path>& tracks, const RiskSpace& space,
                 const FreeSpaceParameters& cells, const RiskMotions& motions, double longest,
                 RiskTree* tree) {
  constexpr int kNowhere = -1;
  const RiskState root = tree->state(0);
  const FreeCells lattice(cells);
  const FreeCells::Cell cell_of_root = lattice.cellOf(space.toPose(root));
  const auto begins = [&](const Pose& pose, const RiskState& state) {
    return lattice.cellOf(pose) == cell_of_root ||
           (motions.distance(root, state) <= longest && motions.within(root, state, 0));
  };
  for (const Path& track : tracks) {
    int parent = kNowhere;
    for (const Pose& pose : track) {
      const RiskState state = space.toState(pose);
      if (!space.isNearWorkspace(state)) {  // it was led there, or is told of it
        parent = kNowhere;
        continue;
      }
      // The robot has been there, but may not get there from where it is now.
      if (parent != kNowhere && motions.passesBarred(tree->state(parent), state)) parent = kNowhere;
      if (parent == kNowhere && !begins(pose, state)) continue;
      parent = tree->add(state, parent == kNowhere ? 0 : parent);
    }
  }
}

}  // namespace smore
