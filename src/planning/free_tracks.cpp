// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/free_tracks.h"

#include <unordered_map>

namespace smore {

void plantTracks(const std::vector<Path>& tracks, const RiskSpace& space,
                 const FreeSpaceParameters& cells, const RiskMotions& motions, double longest,
                 RiskTree* tree) {
  constexpr int kNowhere = -1;
  const RiskState root = tree->state(0);
  const FreeCells lattice(cells);
  std::unordered_map<FreeCells::Cell, int, FreeCells::HashOfCell> node_of;
  node_of.emplace(lattice.cellOf(space.toPose(root)), 0);
  for (const Path& track : tracks) {
    int parent = kNowhere;
    for (const Pose& pose : track) {
      const FreeCells::Cell cell = lattice.cellOf(pose);
      const auto known = node_of.find(cell);
      if (known != node_of.end()) {
        parent = known->second;
        continue;
      }
      const RiskState state = space.toState(pose);
      if (parent == kNowhere && motions.distance(root, state) <= longest &&
          motions.within(root, state, 0)) {
        parent = 0;
      }
      if (parent == kNowhere) continue;
      parent = tree->add(state, parent);
      node_of.emplace(cell, parent);
    }
  }
}

}  // namespace smore
