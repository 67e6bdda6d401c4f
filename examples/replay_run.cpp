// SPDX-License-Identifier: BSD-3-Clause
// Plays a recorded run again, and tells what the belief knew after each touch.
//
//   replay_run FILE.evidence
#include <smore/mapping/octomap_export.h>
#include <smore/retrieval/evidence.h>

#include <algorithm>
#include <iostream>

namespace {

std::size_t occupied(const smore::VoxelGrid& map) {
  return std::count_if(map.voxels().begin(), map.voxels().end(),
                       [](const auto& voxel) { return voxel.probability >= smore::kOccupied; });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: replay_run FILE.evidence\n";
    return 2;
  }
  try {
    const smore::Evidence evidence = smore::readEvidence(argv[1]);
    const smore::EvidenceSource& source = evidence.source;
    smore::Method method = smore::makeMethod(source.method, source.task, source.seed,
                                             source.parameters, source.priors);
    int contacts = 0;
    for (const smore::ContactObservation& observation : evidence.observations) {
      method.observe(observation);
      if (!observation.line) continue;
      std::cout << "touch " << ++contacts << " at " << observation.time << " s with "
                << observation.line->force << " N: " << occupied(method.maps->world())
                << " voxels of the world and " << occupied(method.maps->object())
                << " of the object are likely occupied\n";
    }
    std::cout << evidence.motions.size() << " motions were planned\n";
  } catch (const smore::InputError& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
