// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>

#include "belief_observations.h"
#include "known_boxes.h"
#include "smore/planning/path_value.h"
#include "smore/planning/swept_room.h"

namespace smore {
namespace {

constexpr double kUnit = 0.1;  // of planarParameters [m]

// A bar, 0.4 m long and narrower than a cell, was moved end first from x = 0 to 0.5 m.
JointBelief movedBar() {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, boxKnown({0.0, -0.02, -0.1}, {0.4, 0.02, 0.1}, 0.1));
  for (int cm = 0; cm <= 50; ++cm) belief.observe(freeAt(makePose({0.01 * cm, 0, 0}), cm));
  return belief;
}

const Pose kEnd = makePose({0.5, 0, 0});
const Pose kEndFirst = makePose({1.0, 0, 0});
const Pose kBroadside = makePose({0.5, 0.5, 0});

// A belief's room, and paths in it.
class Room {
 public:
  explicit Room(const JointBelief& belief)
      : worlds_(belief.worlds()),
        space_({Motion::kPlanar, Pose::Identity(), {Vec3(-2, -2, -1), Vec3(2, 2, 1)}},
               worlds_->frame.T_map_world(), 3.0 * kUnit),
        motions_(worlds_->sampled, space_.lever()),
        room_(*worlds_, space_, motions_) {}

  std::vector<RiskState> states(const std::vector<Pose>& path) const {
    std::vector<RiskState> states;
    for (const Pose& pose : path) states.push_back(space_.toState(pose));
    return states;
  }

  double meanAlong(const std::vector<Pose>& path) const {
    const SweptRoom::Shares shares = room_.noSurpriseAlong(states(path));
    return std::accumulate(shares.begin(), shares.end(), 0.0) / kHypotheses;
  }

  double value(const std::vector<Pose>& path, double surprises) const {
    MotionCost cost;
    cost.length = 2.0;
    return PathValue({10.0, 0.2}, &room_, surprises).along(states(path)).of(cost);
  }

 private:
  std::shared_ptr<const Worlds> worlds_;
  RiskSpace space_;
  RiskMotions motions_;
  SweptRoom room_;
};

TEST(SweptRoom, NothingSurprisesWhereTheObjectHasBeen) {
  EXPECT_EQ(Room(movedBar()).meanAlong({kEnd, makePose({0, 0, 0})}), 1.0);
}

// Ten cells of a tenth of a metre were swept, and five more are entered.
TEST(SweptRoom, NewRoomCountsAgainstWhatWasSwept) {
  EXPECT_NEAR(Room(movedBar()).meanAlong({kEnd, kEndFirst}), 10.0 / (10.0 + 5.0), 0.03);
}

// Five cells wide, five on.
TEST(SweptRoom, ALongThingSurprisesMoreBroadside) {
  EXPECT_NEAR(Room(movedBar()).meanAlong({kEnd, kBroadside}), 10.0 / (10.0 + 25.0), 0.03);
}

TEST(SweptRoom, ACellCountsOnceHoweverOftenAPathComesBack) {
  const Room room(movedBar());
  EXPECT_DOUBLE_EQ(room.meanAlong({kEnd, kEndFirst}),
                   room.meanAlong({kEnd, kEndFirst, kEnd, kEndFirst}));
}

TEST(SweptRoom, WhatHasNoMatterIsNotSurprised) {
  JointBelief belief(planarParameters());
  belief.observe(freeAt(Pose::Identity(), 0.0));
  EXPECT_EQ(Room(belief).meanAlong({Pose::Identity(), kEndFirst}), 1.0);
}

TEST(PathValue, IsTheLengthWhereNothingMayTouch) {
  EXPECT_NEAR(Room(movedBar()).value({kEnd, kBroadside}, 0.0), 2.0, 1e-6);
}

TEST(PathValue, CountsNewRoomOnceForEachSurprise) {
  const Room room(movedBar());
  const double once = room.value({kEnd, kEndFirst}, 1.0);
  EXPECT_NEAR(once, 2.0 - 10.0 * std::log(room.meanAlong({kEnd, kEndFirst})), 1e-3);
  EXPECT_NEAR(room.value({kEnd, kEndFirst}, 2.0) - 2.0, 2.0 * (once - 2.0), 0.2);
}

}  // namespace
}  // namespace smore
