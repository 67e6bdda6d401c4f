// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/contact/evidence_filter.h"

namespace smore {
namespace {

ContactObservation at(double x, ContactState state, int contact_id = 0) {
  ContactObservation observation;
  observation.T_world_object = makePose({x, 0.0, 0.0});
  observation.state = state;
  observation.contact_id = contact_id;
  return observation;
}

ContactObservation freeAt(double x) { return at(x, ContactState::kFree); }

TEST(EvidenceFilter, keepsFreePosesThatAreFarEnoughFromTheLastKept) {
  EvidenceFilter filter({0.003, 0.01});
  EXPECT_TRUE(filter.keeps(freeAt(0.0)));
  EXPECT_FALSE(filter.keeps(freeAt(0.0029)));
  EXPECT_TRUE(filter.keeps(freeAt(0.0031)));
  ContactObservation turned = freeAt(0.0031);
  turned.T_world_object = makePose({0.0031, 0.0, 0.0}, {0.0, 0.0, 0.02});
  EXPECT_TRUE(filter.keeps(turned));
}

TEST(EvidenceFilter, keepsEachContactOnceAndEveryLine) {
  EvidenceFilter filter(lossless());
  EXPECT_TRUE(filter.keeps(at(0.0, ContactState::kContact, 1)));
  EXPECT_FALSE(filter.keeps(at(0.1, ContactState::kContact, 1)));
  ContactObservation line = at(0.1, ContactState::kContact, 1);
  line.line = LineOfAction{};
  EXPECT_TRUE(filter.keeps(line));
  line.state = ContactState::kUnsure;
  EXPECT_TRUE(filter.keeps(line)) << "the line of a contact that was lost";
  EXPECT_TRUE(filter.keeps(at(0.1, ContactState::kContact, 2)));
  EXPECT_FALSE(filter.keeps(at(0.2, ContactState::kUnsure, 2)));
}

TEST(EvidenceFilter, withoutLossKeepsEveryFreePoseButRepetitions) {
  EvidenceFilter filter(lossless());
  EXPECT_TRUE(filter.keeps(freeAt(0.1)));
  EXPECT_FALSE(filter.keeps(freeAt(0.1)));
  EXPECT_TRUE(filter.keeps(freeAt(std::nextafter(0.1, 1.0))));
  EXPECT_TRUE(filter.keeps(freeAt(0.1)));
}

TEST(EvidenceFilter, keepsNothingFromBesideThePlane) {
  EvidenceSpacing spacing;
  spacing.T_world_plane = makePose({0.1, 0.2, 0.3}, {0.0, 1.0, 0.0});
  EvidenceFilter filter(spacing);
  const auto freeAbove = [&](double height, double tilt) {
    ContactObservation observation = freeAt(0.0);
    observation.T_world_object =
        *spacing.T_world_plane * makePose({1.0, 2.0, height}, {tilt, 0.0, 3.0});
    return observation;
  };
  ContactObservation touched = freeAbove(-0.2, 0.0);
  touched.state = ContactState::kContact;
  touched.line = LineOfAction{};
  EXPECT_FALSE(filter.keeps(touched));
  EXPECT_FALSE(filter.keeps(freeAbove(0.02, 0.0)));
  EXPECT_FALSE(filter.keeps(freeAbove(0.0, 0.1)));
  EXPECT_FALSE(filter.keeps(freeAbove(0.0, M_PI)));
  EXPECT_TRUE(filter.keeps(freeAbove(0.005, 0.02)));
}

}  // namespace
}  // namespace smore
