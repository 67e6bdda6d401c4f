// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/retrieval/method.h"

namespace smore {
namespace {

// Voxels of the world after one contact of the method paper, with lines that reach so far [m].
std::size_t voxelsOfALine(double reach) {
  MethodParameters parameters;
  parameters.paper.belief.line_half_length = reach;
  Scenario scenario;
  scenario.voxel_size = 0.03;
  const auto maps = makeTwinMap(MethodKind::kPaper, scenario, 1, parameters);
  ContactObservation contact;
  contact.state = ContactState::kContact;
  contact.contact_id = 1;
  contact.line = LineOfAction{};
  contact.line->direction = Vec3::UnitX();
  maps->observe(contact);
  return maps->world().voxels().size();
}

TEST(MethodPaper, IsMadeWithItsParameters) {
  EXPECT_NEAR(voxelsOfALine(1.0), 2.0 / 0.03, 2.0);
  EXPECT_NEAR(voxelsOfALine(0.25), 0.5 / 0.03, 2.0);
}

}  // namespace
}  // namespace smore
