// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "belief_observations.h"
#include "smore/mapping/evidence_at_unit.h"

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

// Corners of the object touch things around it, from free ways.
std::vector<ContactObservation> scene(bool planar) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Vec3(uniform(random), uniform(random), planar ? 0.0 : uniform(random));
  };
  std::vector<Vec3> corners;
  std::vector<Vec3> things;
  for (int i = 0; i < 3; ++i) {
    corners.push_back(0.2 * vector());
    things.push_back(0.5 * vector());
  }
  std::vector<ContactObservation> observations;
  for (int i = 0; i < 9; ++i) {
    const Vec3& corner = corners[i % 3];
    const Pose turn = makePose(Vec3::Zero(), {0, 0, uniform(random)});
    const Vec3 away = turn * (-corner.normalized() + 0.3 * vector());
    const Pose end = makePose(things[i / 3] - turn * corner) * turn;
    for (const double gap : {0.2, 0.1, 0.05, 0.02}) {
      observations.push_back(freeAt(makePose(gap * away) * end, 0));
    }
    observations.push_back(contactAt(end, corner, turn.inverse() * away));
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

// The side of a rod that is held at its end: as long as it is against its breadth, places lie as
// far from the hand as it reaches.
TEST(BeliefScale, AThinThingMayReachFar) {
  constexpr double kBreadth = 0.02;
  constexpr double kLever = 0.7;
  const JointBeliefParameters parameters = planarParameters();
  const MapFrame frame(parameters.T_world_plane);
  const ContactObservation contact = contactAt(Pose::Identity(), {kLever, 0.01, 0}, {0, -1, 0});
  for (const double held : {kBreadth, 0.3}) {
    EvidenceAtUnit evidence(parameters, frame, kBreadth, held);
    evidence.addContact({1, contact.T_world_object, *contact.line});
    const double reach = parameters.feature.reach * held;
    EXPECT_DOUBLE_EQ(evidence.parameters().feature.reach, reach);
    EXPECT_DOUBLE_EQ(evidence.parameters().feature.radius, parameters.feature.radius * kBreadth);
    EXPECT_EQ(evidence.contacts().size(), reach > kLever ? 1U : 0U);
    const double cost = evidence.evidenceOf(evidence.draw({}, 1).samples, 1, reach).cost;
    if (reach > kLever) {
      EXPECT_LT(cost, 1.0);
    } else {
      EXPECT_NEAR(cost, -std::log(parameters.distribution.false_contact), 1e-9);
    }
  }
}

// Nothing is known of where it was: the pose alone is not tried again.
TEST(BeliefScale, AContactOutOfReachOfTheUnitIsKeptAsAPose) {
  JointBeliefParameters parameters = planarParameters();
  JointBelief belief(parameters);
  const Pose pose = makePose({0.3, 0.0, 0.0});
  const double beyond = 1.2 * parameters.unit * parameters.feature.reach;
  belief.observe(contactAt(pose, {0.2, beyond, 0.0}, {-1, 0, 0}));
  const auto worlds = belief.worlds();
  const auto share = [&](const Pose& T_world_object) {
    return SampledWorlds::shareOf(
        worlds->sampled.touching(worlds->frame.toMap(T_world_object).cast<float>()));
  };
  EXPECT_EQ(share(pose), 1.0);
  EXPECT_EQ(share(makePose({0.1, 0.0, 0.0})), 0.0);
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
