// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "belief_observations.h"

namespace smore {
namespace {

ContactObservation scaled(ContactObservation observation, double factor) {
  observation.T_world_object.translation() *= factor;
  if (!observation.line) return observation;
  observation.line->point *= factor;
  observation.line->offset_stddev *= factor;
  observation.line->pitch *= factor;
  return observation;
}

// Touches all around the hand, at levers of all sizes, after ways that were free.
std::vector<ContactObservation> scene(bool planar) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Vec3(uniform(random), uniform(random), planar ? 0.0 : uniform(random));
  };
  std::vector<ContactObservation> observations;
  for (int i = 0; i < 8; ++i) {
    const Pose end = makePose(0.2 * vector(), {0, 0, uniform(random)});
    for (const double share : {0.0, 0.3, 0.6, 0.9}) {
      observations.push_back(freeAt(interpolate(Pose::Identity(), end, share), 0));
    }
    observations.push_back(contactAt(end, 0.2 * vector(), vector()));
  }
  return observations;
}

double probabilityAt(const VoxelGrid& grid, const Vec3& point) {
  return grid.probability(voxelAt(point, grid.voxelSize())).value_or(0.0F);
}

// All that is observed is larger by so many steps of the unit of length: so is what is believed.
// There is no other length in it.
TEST(BeliefScale, WorldsGrowWithTheScene) {
  for (const bool planar : {true, false}) {
    for (const int steps : {-4, 3}) {
      const double factor = unitOfLength(10 + steps) / unitOfLength(10);
      JointBeliefParameters parameters;
      if (planar) parameters.T_world_plane = Pose::Identity();
      JointBelief one(parameters);
      parameters.voxel_size *= factor;
      JointBelief other(parameters);
      for (const ContactObservation& observation : scene(planar)) {
        one.observe(observation);
        other.observe(scaled(observation, factor));
      }
      EXPECT_NEAR(other.worlds()->unit, factor * one.worlds()->unit, 1e-3 * factor);
      ASSERT_GT(one.world().size(), 0U);
      double same = 0.0;
      for (const VoxelGrid::Voxel& voxel : one.world().voxels()) {
        const Vec3 center = voxelCenter(voxel.key, one.world().voxelSize());
        const double difference = probabilityAt(other.world(), factor * center) - voxel.probability;
        same += std::abs(difference) < 0.15 ? 1.0 : 0.0;
      }
      EXPECT_GT(same / static_cast<double>(one.world().size()), 0.9) << planar << ' ' << factor;
    }
  }
}

TEST(BeliefScale, AUnitThatIsToldIsTaken) {
  JointBeliefParameters parameters = planarParameters();
  parameters.unit = 0.25;
  JointBelief belief(parameters);
  observeAll(wallObservations(), &belief);
  EXPECT_NEAR(belief.worlds()->unit, 0.25, 1e-12);
  EXPECT_NEAR(belief.worlds()->feature.radius, 0.25 * parameters.feature.radius, 1e-12);
}

TEST(BeliefScale, WorldsHaveSeveralUnitsWhileFewContactsAreKnown) {
  JointBelief belief{JointBeliefParameters{}};
  belief.observe(contactAt(makePose({0.3, 0, 0}), {0.2, 0.05, 0}, {-1, 0, 0}));
  const auto& parts = belief.worlds()->sampled.parts();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_GT(parts.back().radius(), 2.0 * parts.front().radius());
}

}  // namespace
}  // namespace smore
