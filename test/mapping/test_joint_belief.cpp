// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "belief_observations.h"
#include "smore/mapping/joint_belief.h"

namespace smore {
namespace {

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

// A line that passes farther from the hand than things of the told unit reach says nothing.
TEST(JointBelief, ContactsOutOfReachGoBeforeThoseThatTellSomething) {
  JointBeliefParameters parameters = planarParameters();
  parameters.most_contacts = 10;
  JointBelief belief(parameters);
  const auto told = wallObservations();
  observeAll(told, &belief);
  for (int i = 0; i < 40; ++i) {
    belief.observe(contactAt(makePose({0.3, 0, 0}), {0.0, 1.5 + 0.01 * i, 0}, {-1, 0, 0}));
  }
  EXPECT_EQ(belief.contactCount(), 45U);
  for (const ContactObservation& observation : told) {
    if (!observation.line) continue;
    EXPECT_FALSE(belief.placesOf(observation.T_world_object, *observation.line).empty());
  }
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

// The side of a rod of 4 cm width, `lever` from the hand, touches a post of 2 cm radius at the
// origin, which the rod then points past at `heading`. Where the hand was.
Vec3 touchPost(double lever, double heading, int side, JointBelief* belief) {
  constexpr double kRadius = 0.02;
  const Vec3 along(std::cos(heading), std::sin(heading), 0.0);
  const Vec3 away = side * Vec3(-along.y(), along.x(), 0.0);
  const auto poseAt = [&](double gap) {
    return makePose((2.0 * kRadius + gap) * away - lever * along, {0, 0, heading});
  };
  for (double gap = 0.2; gap > 0.004; gap -= 0.01) belief->observe(freeAt(poseAt(gap), 0));
  belief->observe(contactAt(poseAt(0.0), {lever, -kRadius * side, 0}, {0, 1.0 * side, 0}));
  return poseAt(0.0).translation();
}

// The rod points away from the post, near and far.
void turnAround(JointBelief* belief) {
  for (double distance = 0.1; distance < 1.6; distance += 0.1) {
    for (double heading = 0.0; heading < 2.0 * M_PI; heading += 0.2) {
      const Vec3 hand = distance * Vec3(std::cos(heading), std::sin(heading), 0.0);
      belief->observe(freeAt(makePose(hand, {0, 0, heading}), 0));
    }
  }
}

// As thick as the lever is long, no post has room between the poses at which the rod was free.
TEST(JointBelief, ThinMatterThatIsTouchedWithALongToolIsFoundThin) {
  JointBeliefParameters parameters = planarParameters();
  parameters.unit = 0.0;
  JointBelief belief(parameters);
  turnAround(&belief);
  std::vector<LeverOfContact> levers;
  for (int i = 0; i < 16; ++i) {
    const double lever = 0.3 + 0.04 * (i % 5);
    const Vec3 hand = touchPost(lever, 2.0 * M_PI * i / 16, i % 2 == 0 ? 1 : -1, &belief);
    levers.push_back({lever, 0.0, hand});
  }
  const std::array<double, kUnits> by_levers = unitProbabilities(levers, true);
  const auto likeliest = std::max_element(by_levers.begin(), by_levers.end()) - by_levers.begin();
  EXPECT_GT(unitOfLength(static_cast<int>(likeliest)), 0.25);
  EXPECT_LT(belief.worlds()->unit, 0.15);
  EXPECT_GT(belief.worlds()->held, 0.25);
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
}

// Not even one contact out there may cost the maps of all that was learnt here.
TEST(JointBelief, RefusesObservationsOutsideOfItsMapsAndKeepsThem) {
  JointBelief belief(planarParameters());
  observeAll(wallObservations(), &belief);
  const std::uint64_t before = belief.revision();
  const std::size_t voxels = belief.world().size();
  for (const double far : {1e4, 1e300}) {
    EXPECT_THROW(belief.observe(freeAt(makePose({far, 0, 0}), 0)), std::out_of_range);
    EXPECT_THROW(belief.observe(contactAt(makePose({0, far, 0}), {0.2, 0, 0}, {-1, 0, 0})),
                 std::out_of_range);
  }
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  belief.observe(freeAt(makePose({kNothing, 0, 0}), 0));
  belief.observe(contactAt(makePose({0, kNothing, 0}), {0.2, 0, 0}, {-1, 0, 0}));
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

// The line of a contact that was shorter than its average comes with the first sample after it.
TEST(JointBelief, ShortContactsCountByTheirLinesThatComeWhenTheyAreOver) {
  JointBelief belief(planarParameters());
  ContactObservation contact = contactAt(makePose({0.3, 0, 0}), {0.2, 0, 0}, {-1, 0, 0});
  const auto line = std::exchange(contact.line, std::nullopt);
  belief.observe(contact);
  EXPECT_EQ(belief.contactCount(), 0U);
  ContactObservation over = contact;
  over.state = ContactState::kUnsure;
  over.T_world_object = makePose({0.299, 0, 0});
  belief.observe(over);
  EXPECT_EQ(belief.contactCount(), 0U);
  over.line = line;
  belief.observe(over);
  EXPECT_EQ(belief.contactCount(), 1U);
}

// Where noise does not lengthen its windows, the sensor is sure by then that nothing touches.
TEST(JointBelief, ShortContactsCountTooWhereTheObjectIsFreeWhenTheirLinesCome) {
  JointBelief belief(planarParameters());
  ContactObservation over = contactAt(makePose({0.3, 0, 0}), {0.2, 0, 0}, {-1, 0, 0});
  over.state = ContactState::kFree;
  belief.observe(over);
  EXPECT_EQ(belief.contactCount(), 1U);
}

TEST(JointBelief, WhatIsUnsureIsNoContact) {
  JointBelief belief(planarParameters());
  ContactObservation unsure = contactAt(makePose({0.3, 0, 0}), {0.2, 0, 0}, {-1, 0, 0});
  unsure.state = ContactState::kUnsure;
  unsure.line->point.x() = std::numeric_limits<double>::quiet_NaN();
  belief.observe(unsure);
  EXPECT_EQ(belief.worlds()->sampled.touching(makePose({0.3, 0, 0}).cast<float>()), 0U);
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
  const VoxelGrid world = marginalMap(*before, MapSide::kWorld, 0.02);
  EXPECT_GT(before->inference_s, 0.0);
  ContactObservation next = contactAt(makePose({0.1, 0.0, 0.0}), {0.2, 0.3, 0.0}, {-1, 0, 0});
  next.contact_id = 1000;
  belief.observe(next);
  EXPECT_EQ(belief.worlds()->contacts, 6U);
  EXPECT_EQ(before->contacts, 5U);
  EXPECT_GT(world.size(), 0U);
  EXPECT_EQ(difference(marginalMap(*before, MapSide::kWorld, 0.02), world).first, 0.0);
}

// The first of many threads makes what all of them get.
// A replica is compared with what it replicates by this number.
TEST(JointBelief, RevisesAsOftenWheneverTheMapsAreAskedFor) {
  std::mt19937 random(501);
  std::uniform_real_distribution<double> step(-0.004, 0.004);
  JointBelief asked(planarParameters());
  JointBelief unasked(planarParameters());
  Vec3 place = Vec3::Zero();
  double yaw = 0.0;
  for (int i = 0; i < 400; ++i) {
    place += Vec3(step(random), step(random), 0.0);
    yaw += step(random);
    const Pose pose = makePose(place, {0, 0, yaw});
    const bool touches = i % 80 == 40;
    const auto observation =
        touches ? contactAt(pose, {0.1, 20.0 * step(random), 0}, {-1, 10.0 * step(random), 0})
                : freeAt(pose, 0);
    for (JointBelief* belief : {&asked, &unasked}) belief->observe(observation);
    if (i % 20 == 0) (void)asked.world();
  }
  EXPECT_EQ(asked.revision(), unasked.revision());
  EXPECT_GT(asked.revision(), 100U);
}

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
