// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "at_a_decimetre.h"
#include "contact_at.h"
#include "smore/mapping/contact_merging.h"
#include "smore/mapping/free_space_evidence.h"

namespace smore {
namespace {

const std::vector<ContactHypotheses> kContacts = {
    contactAt({0, 0, 0}, {0, 0, 0}, 1), contactAt({1, 0, 0}, {1, 0, 0}, 2),
    contactAt({0.01, 0, 0}, {0.01, 0, 0}, 3), contactAt({0, 0, 0}, {2, 0, 0}, 4)};

TEST(CoveredContacts, AreThoseWhoseBothSidesOthersTouchedToo) {
  const std::vector<Explanation> explanations = {{0, 0, 0, 0}};
  // Contact 0 and 2 cover each other; once one of them is gone nothing covers the other.
  const auto covered = coveredContacts(kContacts, explanations, atADecimetre().distribution, 1);
  ASSERT_EQ(covered.size(), 1U);
  EXPECT_TRUE(covered[0] == 0 || covered[0] == 2);
}

TEST(CoveredContacts, AFalseContactGoesFirst) {
  const auto covered =
      coveredContacts(kContacts, {{0, kFalseContact, 0, 0}}, atADecimetre().distribution, 2);
  ASSERT_EQ(covered.size(), 2U);
  EXPECT_EQ(covered[0], 1);
}

TEST(CoveredContacts, AreAtMostAll) {
  EXPECT_EQ(coveredContacts(kContacts, {{0, 0, 0, 0}}, atADecimetre().distribution, 9).size(), 4U);
}

TEST(FreeSpaceEvidence, ARemovedContactLeavesNoTrace) {
  const double distance = 0.04;
  FreeSpaceEvidence removed(atADecimetre().free_space, distance);
  FreeSpaceEvidence never(atADecimetre().free_space, distance);
  for (int k = 0; k < 4; ++k) {
    removed.insertContact(k, kContacts[k]);
    if (k != 1) never.insertContact(k < 1 ? k : k - 1, kContacts[k]);
  }
  const auto add_poses = [](FreeSpaceEvidence* evidence) {
    for (const double x : {0.0, 1.0, 2.0}) evidence->addPose(makePose({x, 0, 0}));
  };
  removed.addPose(makePose({0.5, 0, 0}));
  never.addPose(makePose({0.5, 0, 0}));
  removed.removeContact(1);
  add_poses(&removed);
  add_poses(&never);
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const ConflictTable* a = removed.conflicts(k, l);
      const ConflictTable* b = never.conflicts(k, l);
      ASSERT_EQ(a == nullptr, b == nullptr) << k << " " << l;
      if (a == nullptr) continue;
      EXPECT_EQ(a->by_object, b->by_object) << k << " " << l;
    }
  }
}

}  // namespace
}  // namespace smore
