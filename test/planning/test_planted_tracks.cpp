// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/mapping/joint_belief.h"
#include "smore/planning/planted_tracks.h"

namespace smore {
namespace {

constexpr double kLever = 0.3;
constexpr double kLongest = 0.12;

const MotionSpace kSpace{
    Motion::kPlanar, Pose::Identity(), {Vec3(-1.3, -0.7, -0.01), Vec3(0.4, 0.7, 0.01)}, true};

// A tree with its root at the origin, in a plane of which nothing is known but a contact.
class PlantedTracks : public testing::Test {
 protected:
  PlantedTracks() : belief_(parameters()) {
    ContactObservation contact;
    contact.state = ContactState::kContact;
    contact.T_world_object = makePose({0.05, 0, 0});
    contact.line = LineOfAction{Vec3::Zero(), -Vec3::UnitX(), 6.0};
    belief_.observe(contact);
    worlds_ = belief_.worlds();
  }

  static JointBeliefParameters parameters() {
    JointBeliefParameters parameters;
    parameters.unit = 0.1;
    parameters.T_world_plane = Pose::Identity();
    return parameters;
  }

  RiskTree planted(const std::vector<Path>& tracks) const {
    const RiskMotions motions(worlds_->sampled, kLever);
    RiskTree tree(motions, kLongest);
    tree.add(space_.toState(Pose::Identity()), -1);
    plantTracks(tracks, space_, worlds_->free.parameters(), motions, kLongest, &tree);
    return tree;
  }

  static Path along(double x_from, double x_to, double y) {
    return densify({makePose({x_from, y, 0}), makePose({x_to, y, 0})}, 0.05, 1.0);
  }

  JointBelief belief_;
  std::shared_ptr<const Worlds> worlds_;
  RiskSpace space_{kSpace, Pose::Identity(), kLever};
};

TEST_F(PlantedTracks, AreBranchesFromTheRoot) {
  const RiskTree tree = planted({along(0.0, -0.4, 0.0)});
  ASSERT_EQ(tree.size(), 10);
  for (int node = 1; node < tree.size(); ++node) EXPECT_EQ(tree.parent(node), node - 1);
  EXPECT_NEAR(tree.state(9).position.x(), -0.4, 1e-6);
}

TEST_F(PlantedTracks, BeginWhereTheRootReachesThem) {
  const RiskTree tree = planted({along(-0.3, 0.0, 0.0)});
  ASSERT_GT(tree.size(), 1) << "what comes before is not joined";
  EXPECT_LE(std::abs(tree.state(1).position.x()), kLongest);
}

TEST_F(PlantedTracks, ThatBeginInAnotherPostureAreNotJoinedToTheRoot) {
  Path turned = along(0.0, -0.4, 0.0);
  for (Pose& pose : turned) pose = pose * makePose({0, 0, 0}, {0, 0, 1.5});
  EXPECT_EQ(planted({turned}).size(), 1);
}

// Where somebody has led the object, or what a belief of another workspace tells.
TEST_F(PlantedTracks, EndWhereTheyLeaveTheWorkspace) {
  const RiskTree tree = planted({along(0.0, -1.6, 0.0)});
  ASSERT_GT(tree.size(), 20);
  for (int node = 0; node < tree.size(); ++node) EXPECT_GT(tree.state(node).position.x(), -1.31F);
}

TEST_F(PlantedTracks, AreNotJoinedThroughWhatTouches) {
  const Pose beyond = makePose({0.1, 0, 0});
  ASSERT_NE(worlds_->sampled.touching(beyond.cast<float>()), 0U);
  EXPECT_EQ(planted({{beyond}}).size(), 1);
  EXPECT_EQ(planted({{makePose({-0.1, 0, 0})}}).size(), 2);
}

}  // namespace
}  // namespace smore
