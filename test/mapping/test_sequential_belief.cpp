// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "smore/mapping/octomap_export.h"
#include "smore/mapping/probability_laws.h"
#include "smore/mapping/sequential_belief.h"

namespace smore {
namespace {

constexpr double kSize = 0.1;

SequentialBeliefParameters parameters() {
  SequentialBeliefParameters parameters;
  parameters.voxel_size = kSize;
  parameters.line_half_length = 0.5;
  return parameters;
}

ContactObservation contactAlongX(int id, const Vec3& point = Vec3(0.05, 0.05, 0.05)) {
  ContactObservation observation;
  observation.state = ContactState::kContact;
  observation.contact_id = id;
  observation.line = LineOfAction{};
  observation.line->point = point;
  observation.line->direction = Vec3::UnitX();
  return observation;
}

ContactObservation freeAt(const Pose& pose) {
  ContactObservation observation;
  observation.state = ContactState::kFree;
  observation.T_world_object = pose;
  return observation;
}

TEST(SequentialBelief, appliesTheContactLawToAFreshLine) {
  SequentialBelief belief(parameters());
  belief.observe(contactAlongX(1));
  // From x = -0.45 to 0.55 the line crosses the voxels -5 to 5.
  ASSERT_EQ(belief.world().size(), 11u);
  ASSERT_EQ(belief.object().size(), 11u);
  const double prior = 1.0 / 11.0;
  const auto expected = contactLaw(std::vector<VoxelPair>(11, {prior, prior}));
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    EXPECT_NEAR(voxel.probability, expected[0].p, 1e-6);
  }
}

TEST(SequentialBelief, countsTheLineOfAContactOnce) {
  SequentialBelief belief(parameters());
  belief.observe(contactAlongX(1));
  const auto revision = belief.revision();
  for (int i = 0; i < 100; ++i) belief.observe(contactAlongX(1));
  EXPECT_EQ(belief.revision(), revision);
  belief.observe(contactAlongX(2));
  EXPECT_GT(belief.revision(), revision);
}

TEST(SequentialBelief, appliesTheFreeSpaceLawToKnownPairsOnly) {
  SequentialBelief belief(parameters());
  belief.observe(contactAlongX(1));
  const double before = belief.world().voxels()[0].probability;
  // Shifted by three voxels along the line, eight of the eleven voxels still have a partner.
  belief.observe(freeAt(makePose(Vec3(3 * kSize, 0, 0))));
  int lowered = 0;
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    const bool paired = voxel.key.x >= -2;
    const double expected = paired ? freeSpaceLaw({before, before}).p : before;
    EXPECT_NEAR(voxel.probability, expected, 1e-6);
    if (paired) ++lowered;
  }
  EXPECT_EQ(lowered, 8);
  EXPECT_EQ(belief.world().size(), 11u) << "free space adds no voxel";
}

TEST(SequentialBelief, doesNotDependOnTheSamplingRateOfFreePoses) {
  const auto run = [](int samples) {
    SequentialBelief belief(parameters());
    belief.observe(contactAlongX(1));
    for (int i = 0; i < samples; ++i) belief.observe(freeAt(makePose(Vec3(0.2, 0, 0))));
    return belief.world().voxels()[6].probability;
  };
  EXPECT_EQ(run(1), run(500));
}

TEST(SequentialBelief, findsThePointWhereLinesCross) {
  SequentialBelief belief(parameters());
  const Vec3 point(0.05, 0.05, 0.05);
  for (int i = 0; i < 12; ++i) {
    ContactObservation observation = contactAlongX(i + 1, point);
    observation.line->direction = Vec3(std::cos(0.5 * i), std::sin(0.5 * i), 0.0);
    observation.line->point = point;
    belief.observe(observation);
  }
  const auto crossing = belief.world().probability(voxelAt(point, kSize));
  ASSERT_TRUE(crossing);
  EXPECT_GT(*crossing, 0.9F);
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    EXPECT_LE(voxel.probability, *crossing);
  }
}

TEST(SequentialBelief, clampsItsValues) {
  SequentialBelief belief(parameters());
  for (int i = 1; i <= 200; ++i) belief.observe(contactAlongX(i));
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    EXPECT_LE(voxel.probability, 0.995F);
    EXPECT_GE(voxel.probability, 0.005F);
  }
}

TEST(SequentialBelief, refusesImpossibleParameters) {
  SequentialBeliefParameters bad = parameters();
  bad.line_half_length = 0.0;
  EXPECT_THROW(SequentialBelief{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace smore
