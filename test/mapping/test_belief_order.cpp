// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "belief_observations.h"
#include "smore/mapping/joint_belief.h"

namespace smore {
namespace {

std::vector<ContactObservation> shuffled(std::vector<ContactObservation> observations,
                                         std::mt19937* random) {
  std::shuffle(observations.begin(), observations.end(), *random);
  return observations;
}

// To the last bit.
void expectSameMaps(const JointBelief& a, const JointBelief& b) {
  for (const auto& [one, other] :
       {std::pair(&a.world(), &b.world()), std::pair(&a.object(), &b.object())}) {
    EXPECT_GT(one->size(), 0U);
    EXPECT_EQ(one->size(), other->size());
    EXPECT_EQ(difference(*one, *other).first, 0.0);
  }
}

void expectNoTraceOfTheOrder(const std::vector<ContactObservation>& observations,
                             const JointBeliefParameters& parameters) {
  JointBelief reference(parameters);
  observeAll(observations, &reference);
  std::mt19937 random(4);
  for (int permutation = 0; permutation < 4; ++permutation) {
    JointBelief belief(parameters);
    observeAll(shuffled(observations, &random), &belief);
    expectSameMaps(reference, belief);
  }
}

TEST(BeliefOrder, TheOrderOf20ObservationsDoesNotMatter) {
  ASSERT_EQ(wallObservations().size(), 20U);
  expectNoTraceOfTheOrder(wallObservations(), planarParameters());
}

// As a robot records it: many poses in each cell, none of them at its centre, and the same ways
// again and again on which they lie otherwise.
std::vector<ContactObservation> recordedRun(bool planar) {
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<ContactObservation> observations;
  double time = 0.0;
  for (int motion = 0; motion < 8; ++motion) {
    const double height = planar ? 0.0 : 0.1 * uniform(engine);
    const double tilt = planar ? 0.0 : 0.2 * uniform(engine);
    const Path way = {makePose({0, 0, 0}), makePose({0.28, 0.1 * uniform(engine), height},
                                                    {tilt, 0, 0.2 * uniform(engine)})};
    for (const Pose& pose : densify(way, 0.0007, 0.01)) {
      observations.push_back(freeAt(pose, time += 0.002));
    }
    ContactObservation contact =
        contactAt(interpolate(way[0], way[1], 1.03), {0.2, 0.03 * uniform(engine), 0},
                  {-1, 0.2 * uniform(engine), planar ? 0.0 : 0.2 * uniform(engine)});
    contact.time = time += 0.002;
    contact.contact_id = motion + 1;
    if (motion % 4 == 3) contact.line.reset();
    observations.push_back(contact);
  }
  return observations;
}

TEST(BeliefOrder, TheOrderOfARecordedRunDoesNotMatter) {
  expectNoTraceOfTheOrder(recordedRun(true), planarParameters());
}

TEST(BeliefOrder, TheOrderOfARecordedRunInSpaceDoesNotMatter) {
  expectNoTraceOfTheOrder(recordedRun(false), {});
}

// Until its line has come a contact is known by its first pose, whichever comes in first.
TEST(BeliefOrder, AContactWithoutALineIsKnownByItsFirstPose) {
  std::vector<ContactObservation> pressing;
  for (int i = 0; i < 6; ++i) {
    pressing.push_back(contactAt(makePose({0.3 + 0.01 * i, 0, 0}), {0.2, 0, 0}, {-1, 0, 0}));
    pressing.back().time = i;
    pressing.back().line.reset();
  }
  std::mt19937 random(2);
  for (int permutation = 0; permutation < 5; ++permutation) {
    JointBelief belief(planarParameters());
    observeAll(shuffled(pressing, &random), &belief);
    const auto touching = [&](double x) {
      return belief.worlds()->sampled.touching(makePose({x, 0, 0}).cast<float>());
    };
    EXPECT_NE(touching(0.3), 0U);
    EXPECT_EQ(touching(0.35), 0U);
  }
}

// The same motion, sampled at a rate [Hz]: up to the wall, aside and up again.
JointBelief recorded(double rate) {
  JointBelief belief(planarParameters());
  const Path path = {makePose({0, 0, 0}), makePose({0.29, 0.05, 0}),
                     makePose({0.1, 0.12, 0}, {0, 0, 0.4}),
                     makePose({0.28, -0.03, 0}, {0, 0, 0.1})};
  constexpr double kSpeed = 0.1;  // [m/s]
  const double spacing = kSpeed / rate;
  double time = 0.0;
  for (const Pose& pose : densify(path, spacing, 1.0)) {
    belief.observe(freeAt(pose, time));
    time += 1.0 / rate;
  }
  belief.observe(contactAt(makePose({0.3, 0.05, 0}), {0.2, 0, 0}, {-1, 0, 0}));
  belief.observe(contactAt(makePose({0.3, -0.03, 0}, {0, 0, 0.1}), {0.2, 0.01, 0}, {-1, 0.1, 0}));
  return belief;
}

TEST(BeliefOrder, TheRateOfFreeSamplesDoesNotMatter) {
  const JointBelief slow = recorded(250.0);
  const JointBelief fast = recorded(1000.0);
  EXPECT_LE(difference(slow.world(), fast.world()).first, 0.05);
  EXPECT_LE(difference(slow.object(), fast.object()).first, 0.05);
}

TEST(BeliefOrder, ARepeatedObservationCountsOnce) {
  JointBelief once(planarParameters());
  JointBelief twice(planarParameters());
  const auto observations = wallObservations();
  observeAll(observations, &once);
  observeAll(observations, &twice);
  observeAll(observations, &twice);
  EXPECT_EQ(difference(once.world(), twice.world()).first, 0.0);
  EXPECT_EQ(difference(once.object(), twice.object()).first, 0.0);
}

}  // namespace
}  // namespace smore
