// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "smore/mapping/object_agreement.h"

namespace smore {
namespace {

constexpr double kSpread = 0.02;
constexpr double kReach = 0.6;
constexpr double kWidest = 1.5;

// Contacts that have one place each, and the sample that has them there.
struct Touches {
  std::vector<ContactHypotheses> contacts;
  JointSample sample;

  void add(const Vec3& place) {
    ContactHypotheses contact;
    contact.count = 1;
    contact.object.set(0, place);
    contacts.push_back(contact);
    sample.places.push_back(0);
  }
  double agreement(double spread, double reach, bool planar, int elsewhere = 0) const {
    return objectAgreement(contacts, {sample}, {spread, reach, kWidest, planar}, elsewhere);
  }
};

double anywhere(bool planar, double reach = kReach) {
  return planar ? 1.0 / (M_PI * reach * reach) : 0.75 / (M_PI * std::pow(reach, 3));
}

TEST(ObjectAgreement, TheFirstTouchMayBeAnywhere) {
  for (const bool planar : {true, false}) {
    Touches touches;
    touches.add({0.1, 0.2, 0.0});
    EXPECT_NEAR(touches.agreement(kSpread, kReach, planar), std::log(anywhere(planar)), 1e-12);
  }
}

// Neither what is held to be false nor what is out of reach is better explained by a smaller reach.
TEST(ObjectAgreement, AFalseContactSaysTheSameWhateverTheReach) {
  for (const bool planar : {true, false}) {
    Touches touches;
    touches.add({0.1, 0.2, 0.0});
    touches.sample.places[0] = kFalseContact;
    const double of_false_contact = std::log(anywhere(planar, kWidest));
    for (const double reach : {0.1 * kReach, kReach}) {
      EXPECT_NEAR(touches.agreement(kSpread, reach, planar), of_false_contact, 1e-12);
      EXPECT_NEAR(touches.agreement(kSpread, reach, planar, 2), 3.0 * of_false_contact, 1e-12);
    }
  }
}

TEST(ObjectAgreement, ATouchAtTheSamePlaceWasExpected) {
  for (const bool planar : {true, false}) {
    Touches touches;
    for (int i = 0; i < 2; ++i) touches.add({0.1, 0.2, 0.0});
    const double peak =
        planar ? 1.0 / (M_PI * std::pow(kSpread, 2)) : 1.0 / (M_PI * M_PI * std::pow(kSpread, 3));
    EXPECT_NEAR(touches.agreement(kSpread, kReach, planar),
                std::log(anywhere(planar)) + std::log(0.5 * (anywhere(planar) + peak)), 1e-5);
  }
}

// What the second touch was expected to be, over where it may be: all but the tail of the kernel.
TEST(ObjectAgreement, IsADensity) {
  constexpr double kCell = 0.004;
  double sum = 0.0;
  for (double x = -0.5 * kReach; x < 0.5 * kReach; x += kCell) {
    for (double y = -0.5 * kReach; y < 0.5 * kReach; y += kCell) {
      Touches touches;
      touches.add(Vec3::Zero());
      touches.add({x, y, 0.0});
      const double both = std::exp(touches.agreement(kSpread, kReach, true));
      sum += both / anywhere(true) * kCell * kCell;
    }
  }
  EXPECT_NEAR(sum, 0.5 + 0.5 / M_PI, 0.01);  // of a square of its width the disc has pi
}

// Touches around a few corners, as broadly as a kernel is.
TEST(ObjectAgreement, IsBestAtTheBreadthOfTheTouches) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const bool planar : {true, false}) {
    Touches touches;
    for (int i = 0; i < 60; ++i) {
      const Vec3 corner(0.3 * (i % 3) - 0.3, 0.2 * (i % 2), 0.0);
      touches.add(corner +
                  kSpread * Vec3(normal(random), normal(random), planar ? 0.0 : normal(random)));
    }
    const double best = touches.agreement(kSpread, kReach, planar);
    EXPECT_GT(best, touches.agreement(0.2 * kSpread, kReach, planar));
    EXPECT_GT(best, touches.agreement(6.0 * kSpread, kReach, planar));
  }
}

}  // namespace
}  // namespace smore
