// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "smore/mapping/joint_belief.h"

namespace smore {
namespace {

ContactObservation freeAt(const Pose& pose, double time) {
  ContactObservation observation;
  observation.time = time;
  observation.T_world_object = pose;
  observation.state = ContactState::kFree;
  return observation;
}

// Contact at `pose` at the point `place` of the object [object frame] with the force along
// `direction`.
ContactObservation contactAt(const Pose& pose, const Vec3& place, const Vec3& direction) {
  ContactObservation observation;
  observation.T_world_object = pose;
  observation.state = ContactState::kContact;
  LineOfAction line;
  line.direction = direction.normalized();
  line.point = place - place.dot(line.direction) * line.direction;
  line.force = 5.0;
  observation.line = line;
  return observation;
}

JointBeliefParameters planarParameters() {
  JointBeliefParameters parameters;
  parameters.T_world_plane = Pose::Identity();
  return parameters;
}

// A 4 cm wide bar that reaches 0.2 m ahead of the hand, pushed against a wall at x = 0.5 at several
// heights: lines along x with their contact at 0.2 m on the object, and free poses on the way
// there.
std::vector<ContactObservation> wallObservations() {
  std::vector<ContactObservation> observations;
  for (int i = 0; i < 5; ++i) {
    const double y = 0.04 * i - 0.08;
    for (const double x : {0.0, 0.15, 0.28}) observations.push_back(freeAt(makePose({x, y, 0}), 0));
    observations.push_back(
        contactAt(makePose({0.3, y, 0}), {0.2, 0.01 * (i % 3) - 0.01, 0}, {-1, 0.01 * i, 0}));
  }
  return observations;
}

void observeAll(const std::vector<ContactObservation>& observations, JointBelief* belief) {
  for (const ContactObservation& observation : observations) belief->observe(observation);
}

// Largest and mean difference over the voxels that either grid knows.
std::pair<double, double> difference(const VoxelGrid& a, const VoxelGrid& b) {
  double largest = 0.0;
  double sum = 0.0;
  const auto compare = [&](const VoxelGrid& from, const VoxelGrid& to) {
    for (const VoxelGrid::Voxel& voxel : from.voxels()) {
      const double other = to.probability(voxel.key).value_or(0.005F);
      const double gap = std::abs(voxel.probability - other);
      largest = std::max(largest, gap);
      sum += gap;
    }
  };
  compare(a, b);
  compare(b, a);
  return {largest, sum / std::max<std::size_t>(1, a.size() + b.size())};
}

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

TEST(JointBelief, TheOrderOf20ObservationsDoesNotMatter) {
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

TEST(JointBelief, TheOrderOfARecordedRunDoesNotMatter) {
  expectNoTraceOfTheOrder(recordedRun(true), planarParameters());
}

TEST(JointBelief, TheOrderOfARecordedRunInSpaceDoesNotMatter) {
  expectNoTraceOfTheOrder(recordedRun(false), {});
}

// Until its line has come a contact is known by its first pose, whichever comes in first.
TEST(JointBelief, AContactWithoutALineIsKnownByItsFirstPose) {
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

TEST(JointBelief, TheRateOfFreeSamplesDoesNotMatter) {
  const JointBelief slow = recorded(250.0);
  const JointBelief fast = recorded(1000.0);
  EXPECT_LE(difference(slow.world(), fast.world()).first, 0.05);
  EXPECT_LE(difference(slow.object(), fast.object()).first, 0.05);
}

TEST(JointBelief, ARepeatedObservationCountsOnce) {
  JointBelief once(planarParameters());
  JointBelief twice(planarParameters());
  const auto observations = wallObservations();
  observeAll(observations, &once);
  observeAll(observations, &twice);
  observeAll(observations, &twice);
  EXPECT_EQ(difference(once.world(), twice.world()).first, 0.0);
  EXPECT_EQ(difference(once.object(), twice.object()).first, 0.0);
}

// A thin finger at (0.12, 0) of the object touches a thin peg from `count` directions; on each way
// there the object was free. The lines measured are shifted by `miss` to either side in turn.
constexpr double kFinger = 0.12;
const Vec3 kPeg(0.4, 0.1, 0.0);

void touchPeg(int count, JointBelief* belief, double miss = 0.0) {
  for (int i = 0; i < count; ++i) {
    const double heading = 2.0 * M_PI * i / count;
    const Vec3 along(std::cos(heading), std::sin(heading), 0.0);
    const auto poseAt = [&](double gap) {
      return makePose(kPeg - (kFinger + gap) * along, {0, 0, heading});
    };
    for (double gap = 0.2; gap > 0.004; gap -= 0.01) belief->observe(freeAt(poseAt(gap), 0));
    const double shift = i % 2 == 0 ? miss : -miss;
    ContactObservation contact = contactAt(poseAt(0.0), {kFinger, shift, 0}, {-1, 0, 0});
    contact.line->offset_stddev = miss;
    belief->observe(contact);
  }
}

// Largest occupancy within a voxel's size of the peg.
double pegProbability(const JointBelief& belief) {
  double largest = 0.0;
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    const double distance = (voxelCenter(voxel.key, 0.03) - kPeg).head<2>().norm();
    if (distance < 0.03) largest = std::max<double>(largest, voxel.probability);
  }
  return largest;
}

TEST(JointBelief, LinesThatCrossShowThePeg) {
  JointBelief belief(planarParameters());
  touchPeg(6, &belief);
  EXPECT_GT(pegProbability(belief), 0.8);
}

TEST(JointBelief, OneFalseContactDoesNotRuinTheMaps) {
  JointBelief belief(planarParameters());
  touchPeg(6, &belief);
  // A spike in the middle of a motion that was free before.
  belief.observe(contactAt(makePose(kPeg - Vec3(0.22, 0, 0)), {0.05, 0.0, 0}, {0.3, 1, 0}));
  EXPECT_GT(pegProbability(belief), 0.7);
}

TEST(JointBelief, MergedContactsStayInTheMaps) {
  JointBeliefParameters parameters = planarParameters();
  parameters.most_contacts = 10;
  JointBelief belief(parameters);
  touchPeg(30, &belief);
  EXPECT_EQ(belief.contactCount(), 30U);
  EXPECT_GT(pegProbability(belief), 0.8);
}

// The lines miss the peg by a centimetre to either side in turn, as they state.
TEST(JointBelief, LinesThatMissByWhatTheyStateShowThePegToo) {
  JointBelief belief(planarParameters());
  constexpr double kMiss = 0.01;
  touchPeg(8, &belief, kMiss);
  EXPECT_GT(pegProbability(belief), 0.7);
}

TEST(JointBelief, ProbabilitiesStayInsideAndResetForgets) {
  JointBelief belief(planarParameters());
  EXPECT_TRUE(belief.world().empty());
  const std::uint64_t before = belief.revision();
  observeAll(wallObservations(), &belief);
  EXPECT_GT(belief.revision(), before);
  ASSERT_FALSE(belief.world().empty());
  for (const VoxelGrid::Voxel& voxel : belief.world().voxels()) {
    EXPECT_GE(voxel.probability, 0.005F);
    EXPECT_LE(voxel.probability, 0.995F);
  }
  belief.reset();
  EXPECT_TRUE(belief.world().empty());
  EXPECT_TRUE(belief.object().empty());
  EXPECT_EQ(belief.contactCount(), 0U);
}

// Not even one contact out there may cost the maps of all that was learnt here.
TEST(JointBelief, ObservationsAtPosesThatTheMapsDoNotReachAreLeftOut) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  JointBelief belief(planarParameters());
  observeAll(wallObservations(), &belief);
  const std::uint64_t before = belief.revision();
  const std::size_t voxels = belief.world().size();
  for (const double far : {kNothing, 1e4, 1e300}) {
    belief.observe(freeAt(makePose({far, 0, 0}), 0));
    belief.observe(contactAt(makePose({0, far, 0}), {0.2, 0, 0}, {-1, 0, 0}));
  }
  EXPECT_EQ(belief.revision(), before);
  EXPECT_EQ(belief.world().size(), voxels);
}

TEST(JointBelief, AContactWhoseLineIsNotFiniteIsKnownByItsPose) {
  JointBelief belief(planarParameters());
  ContactObservation contact = contactAt(makePose({0.3, 0, 0}), {0.2, 0, 0}, {-1, 0, 0});
  contact.line->point.x() = std::numeric_limits<double>::quiet_NaN();
  belief.observe(contact);
  EXPECT_EQ(belief.contactCount(), 0U);
  EXPECT_NE(belief.worlds()->sampled.touching(makePose({0.3, 0, 0}).cast<float>()), 0U);
}

// One value: it does not change when the belief does, and all who ask meanwhile get the same one.
TEST(JointBelief, WorldsStayAsTheyAreWhileTheBeliefLearnsOn) {
  JointBelief belief(planarParameters());
  observeAll(wallObservations(), &belief);
  belief.update();
  std::vector<std::shared_ptr<const Worlds>> asked(4);
  std::vector<std::thread> threads;
  for (auto& worlds : asked) threads.emplace_back([&] { worlds = belief.worlds(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& worlds : asked) EXPECT_EQ(worlds, belief.worlds());
  const std::shared_ptr<const Worlds> before = belief.worlds();
  const VoxelGrid world = before->world;
  EXPECT_GT(before->inference_s, 0.0);
  EXPECT_EQ(before->resets, 0U);
  belief.reset();
  EXPECT_TRUE(belief.world().empty());
  EXPECT_EQ(belief.worlds()->resets, 1U);
  EXPECT_EQ(before->contacts, 5U);
  EXPECT_GT(world.size(), 0U);
  EXPECT_EQ(difference(before->world, world).first, 0.0);
}

// The first of many threads makes what all of them get.
TEST(JointBelief, ThreadsThatAskAtOnceShareOneInference) {
  JointBelief belief(planarParameters());
  observeAll(wallObservations(), &belief);
  std::vector<std::shared_ptr<const Worlds>> asked(8);
  std::vector<std::thread> threads;
  for (auto& worlds : asked) threads.emplace_back([&] { worlds = belief.worlds(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& worlds : asked) EXPECT_EQ(worlds, asked.front());
}

TEST(JointBelief, ALineOutOfThePlaneOfMotionSaysNothing) {
  JointBelief belief(planarParameters());
  belief.observe(contactAt(makePose({0.3, 0, 0}), {0.2, 0, 0}, {0.1, 0, 1}));
  EXPECT_EQ(belief.contactCount(), 0U);
}

}  // namespace
}  // namespace smore
