// SPDX-License-Identifier: BSD-3-Clause
// Both maps from five touches. A finger with a round tip, 10 cm before the hand, touches a round
// peg from five sides; the belief knows neither, only the force at the hand and where the hand was
// free.
#include <smore/mapping/joint_belief.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using smore::Pose;
using smore::Vec3;

int main() {
  const Vec3 peg(0.3, 0.1, 0.0);  // in the world [m]; its radius is 3 cm
  const Vec3 tip(0.1, 0.0, 0.0);  // in the object frame; 1 cm
  const double touching = 0.03 + 0.01;

  smore::JointBeliefParameters parameters;
  parameters.voxel_size = 0.02;
  parameters.T_world_plane = Pose::Identity();  // the hand moves in the plane z = 0
  smore::JointBelief belief(parameters);

  std::cout << std::fixed << std::setprecision(2);
  for (int touch = 1; touch <= 5; ++touch) {
    const double angle = 2.0 * M_PI * touch / 5.0;
    const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);

    smore::ContactObservation observation;
    observation.contact_id = touch - 1;  // contacts so far
    observation.state = smore::ContactState::kFree;
    for (double gap = 0.2; gap > 0.0; gap -= 0.01) {  // straight towards the peg
      observation.time += 0.1;
      observation.T_world_object = smore::makePose(peg + (touching + gap) * outwards - tip);
      belief.observe(observation);
    }

    smore::Wrench wrench;  // what the peg does to the object, in the object frame
    wrench.force = 8.0 * outwards;
    wrench.torque = (tip - 0.01 * outwards).cross(wrench.force);
    observation.time += 0.1;
    observation.T_world_object = smore::makePose(peg + touching * outwards - tip);
    observation.state = smore::ContactState::kContact;
    observation.contact_id = touch;
    observation.line = *smore::lineOfAction(wrench, 1.0);
    belief.observe(observation);

    const auto at = [](const smore::VoxelGrid& map, const Vec3& point) {
      return map.probability(smore::voxelAt(point, map.voxelSize())).value_or(0.0F);
    };
    std::cout << "after touch " << touch << ": matter at the peg " << at(belief.world(), peg)
              << ", at the tip " << at(belief.object(), tip) << ", half-way to the hand "
              << at(belief.object(), 0.5 * tip) << "\n";
  }
}
