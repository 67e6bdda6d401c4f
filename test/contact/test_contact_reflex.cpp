// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/contact/contact_reflex.h"

namespace smore {
namespace {

constexpr bool kFree = false;
constexpr bool kTouching = true;

TEST(ContactReflex, ANewContactEndsAMotionOnce) {
  ContactReflex reflex;
  reflex.onMotion();
  EXPECT_FALSE(reflex.onObservation(kFree, 0));
  EXPECT_TRUE(reflex.onObservation(kTouching, 1));
  EXPECT_FALSE(reflex.onObservation(kTouching, 1));
}

TEST(ContactReflex, AMotionThatBeganInContactMayRub) {
  ContactReflex reflex;
  reflex.onMotion();
  reflex.onObservation(kTouching, 1);
  reflex.onMotion();
  EXPECT_FALSE(reflex.onObservation(kFree, 1));
  EXPECT_FALSE(reflex.onObservation(kTouching, 2));
  EXPECT_FALSE(reflex.onObservation(kFree, 2));
  reflex.onMotion();
  EXPECT_TRUE(reflex.onObservation(kTouching, 3));
}

}  // namespace
}  // namespace smore
