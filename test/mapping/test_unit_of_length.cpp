// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "smore/mapping/unit_of_length.h"

namespace smore {
namespace {

// As they are where this is the unit, and it is touched so many units apart.
std::vector<LeverOfContact> levers(double unit, int count, bool planar, unsigned seed) {
  std::mt19937 random(seed);
  std::student_t_distribution<double> across(4.0);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  std::vector<LeverOfContact> result;
  for (int i = 0; i < count; ++i) {
    const double first = unit * across(random);
    result.push_back({planar ? std::abs(first) : std::hypot(first, unit * across(random)), 0.0,
                      unit * Vec3(uniform(random), uniform(random), 0.0)});
  }
  return result;
}

double meanIndex(const std::array<double, kUnits>& probabilities) {
  double mean = 0.0;
  for (int i = 0; i < kUnits; ++i) mean += i * probabilities[i];
  return mean;
}

TEST(UnitOfLength, AllAreEqualBeforeTheFirstContact) {
  for (const double probability : unitProbabilities({}, true)) {
    EXPECT_DOUBLE_EQ(probability, 1.0 / kUnits);
  }
}

TEST(UnitOfLength, IsFoundFromContactsOfItsSize) {
  for (const bool planar : {true, false}) {
    for (const int index : {4, 8, 12, 15}) {
      const auto found = unitProbabilities(levers(unitOfLength(index), 200, planar, index), planar);
      EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.0), 1.0, 1e-12);
      EXPECT_NEAR(meanIndex(found), index, 1.0) << planar;
    }
  }
}

// The same levers in a scene that is larger by the ratio of two neighbouring units.
TEST(UnitOfLength, ScalesWithTheScene) {
  const double ratio = unitOfLength(1) / unitOfLength(0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<LeverOfContact> scene = levers(unitOfLength(9), 5, true, seed);
    for (LeverOfContact& lever : scene) lever.offset += 0.1 * unitOfLength(9);
    const auto before = unitProbabilities(scene, true);
    for (LeverOfContact& lever : scene) {
      lever.offset *= ratio;
      lever.origin *= ratio;
    }
    const auto after = unitProbabilities(scene, true);
    for (int i = 3; i < kUnits - 3; ++i) {
      EXPECT_NEAR(std::log(after[i + 1] / after[i]), std::log(before[i] / before[i - 1]), 1e-9);
    }
  }
}

TEST(UnitOfLength, APushThatIsHeadOnDecidesNothing) {
  std::vector<LeverOfContact> scene = levers(unitOfLength(10), 6, true, 3);
  const double before = meanIndex(unitProbabilities(scene, true));
  scene.push_back({0.0, 0.0, scene.front().origin});
  EXPECT_NEAR(meanIndex(unitProbabilities(scene, true)), before, 0.5);
  const auto alone = unitProbabilities({{0.0, 0.0, Vec3::Zero()}}, true);
  EXPECT_GT(alone[kUnits - 1], 0.1 * alone[5]);
}

TEST(UnitOfLength, ALineThatIsKnownNoBetterDoesNotTellItFromSmallerOnes) {
  const auto found = unitProbabilities({{0.05, 0.08, Vec3::Zero()}}, false);
  for (int i = 1; unitOfLength(i) < 0.02; ++i) EXPECT_NEAR(found[i] / found[0], 1.0, 0.1);
  EXPECT_LT(found[kUnits - 1], 0.1 * found[0]);
}

// The tip of a rod is touched along its axis again and again: where it was says how large things
// are.
TEST(UnitOfLength, TouchesFarApartSpeakAgainstASmallOne) {
  std::vector<LeverOfContact> near;
  std::vector<LeverOfContact> far;
  for (int i = 0; i < 6; ++i) {
    near.push_back({0.0, 0.0, Vec3(0.01 * i, 0, 0)});
    far.push_back({0.0, 0.0, Vec3(1.0 * i, 0, 0)});
  }
  const double gap =
      meanIndex(unitProbabilities(far, true)) - meanIndex(unitProbabilities(near, true));
  EXPECT_GT(gap, 3.0);
}

// Levers that are sure of one unit, and what the contacts say by unit; what was asked for.
struct Explained {
  static constexpr int kByLevers = 12;
  std::array<UnitEvidence, kUnits> at{};
  std::vector<int> asked;

  std::array<double, kUnits> probabilities() {
    std::array<double, kUnits> by_levers{};
    by_levers[kByLevers] = 1.0;
    return probabilitiesByEvidence(by_levers, 3, [this](int index) {
      asked.push_back(index);
      return at[index];
    });
  }
};

TEST(UnitOfLength, LeversAreBelievedWhereNothingContradicts) {
  Explained explained;
  for (int i = 0; i < kUnits; ++i) explained.at[i] = {2.0, -10.0 * i};
  const auto found = explained.probabilities();
  EXPECT_EQ(found[Explained::kByLevers], 1.0);
  EXPECT_EQ(explained.asked, std::vector<int>({Explained::kByLevers}));
}

// As where thin things are touched with a long tool: each smaller unit contradicts less.
TEST(UnitOfLength, ASmallerOneIsTakenWhereTheLeversLeadToContradictions) {
  Explained explained;
  for (int i = 0; i < kUnits; ++i) explained.at[i].cost = 10.0 * std::abs(i - 9);
  const auto found = explained.probabilities();
  EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(found[9], 0.6);
  EXPECT_GT(found[7] + found[8] + found[9], 0.9);
  EXPECT_EQ(explained.asked, std::vector<int>({12, 11, 10, 9}));
}

// A thing that is thin against its lever, between whose units one is dearer than both. The first
// that is bearable is the last to be asked: touches at one place agree best at the smallest unit.
TEST(UnitOfLength, TouchesThatForeseeOneAnotherLeadPastACostlyOne) {
  Explained explained;
  for (int i = 0; i < kUnits; ++i) explained.at[i] = {30.0, -20.0 * i};
  explained.at[10].cost = 45.0;
  explained.at[9].cost = 2.0;
  const auto found = explained.probabilities();
  EXPECT_GT(found[9], 0.6);
  EXPECT_GT(found[7] + found[8] + found[9], 0.9);
  EXPECT_EQ(explained.asked, std::vector<int>({12, 11, 10, 9}));
}

// Of units that all cost something, the one at which the touches agree.
TEST(UnitOfLength, TheOneAtWhichTouchesAgreeIsTaken) {
  Explained explained;
  for (int i = 0; i < kUnits; ++i) explained.at[i] = {8.0, -20.0 * std::abs(i - 10)};
  EXPECT_GT(explained.probabilities()[10], 0.99);
  EXPECT_EQ(explained.asked, std::vector<int>({12, 11, 10, 9}));
}

// Levers that leave several units open, of which one costs more than the others.
TEST(UnitOfLength, AgreementByChanceCountsForNothingWhereTheLeversAreBorneOut) {
  std::array<double, kUnits> by_levers{};
  for (const int index : {9, 12, 15}) by_levers[index] = 1.0 / 3.0;
  const auto found = [&](double agreement) {
    return probabilitiesByEvidence(by_levers, 3, [agreement](int index) {
      return UnitEvidence{index == 15 ? 5.0 : 1.0, agreement * index};
    });
  };
  EXPECT_EQ(found(4.0), found(0.0));
  EXPECT_NEAR(found(4.0)[15] / found(4.0)[9], std::exp(-2.0), 0.02);
}

// As where a contact is out of the smallest one's reach: a touch far from the hand says that things
// are large, not that they are thin.
TEST(UnitOfLength, NoSmallerOneIsAskedWhereALargerOneExplainsAll) {
  std::array<double, kUnits> by_levers{};
  for (const int index : {9, 12, 15}) by_levers[index] = 1.0 / 3.0;
  std::vector<int> asked;
  const auto found = probabilitiesByEvidence(by_levers, 3, [&asked](int index) {
    asked.push_back(index);
    return UnitEvidence{index == 15 ? 0.0 : 4.0, -20.0 * index};
  });
  EXPECT_EQ(asked, std::vector<int>({9, 12, 15}));
  EXPECT_GT(found[15], found[9]);
}

// What contradicts at every unit, such as lines that are known badly, says nothing of it.
TEST(UnitOfLength, WhatIsEqualEverywhereLeavesTheLeversTheirSay) {
  Explained explained;
  explained.at.fill({50.0, -30.0});
  EXPECT_GT(explained.probabilities()[Explained::kByLevers], 0.94);
  EXPECT_EQ(explained.asked, std::vector<int>({12, 11}));
}

TEST(UnitOfLength, WorldsAreSharedOutByEqualParts) {
  std::array<double, kUnits> probabilities{};
  probabilities[3] = 0.3;
  probabilities[4] = 0.4;
  probabilities[7] = 0.3;
  const auto counts = worldsOfUnits(probabilities, 64, 3);
  EXPECT_EQ(counts[3] + counts[4] + counts[7], 64);
  for (const int index : {3, 4, 7}) EXPECT_NEAR(counts[index], 64.0 / 3.0, 1.0);

  std::array<double, kUnits> sure{};
  sure[5] = 1.0;
  EXPECT_EQ(worldsOfUnits(sure, 64, 3)[5], 64);
}

}  // namespace
}  // namespace smore
