// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>

#include "../contact/distance_to_line.h"
#include "../mapping/belief_observations.h"
#include "smore/ros/belief_markers.h"
#include "smore/ros/ghost_markers.h"
#include "smore/ros/marker_parts.h"
#include "smore/ros/scene_markers.h"

namespace smore {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const FrameNames kFrames;

std::shared_ptr<const Worlds> worldsOfTheWall(const Pose& T_world_plane = Pose::Identity()) {
  JointBeliefParameters parameters = planarParameters();
  parameters.T_world_plane = T_world_plane;
  JointBelief belief(parameters);
  for (ContactObservation observation : wallObservations()) {
    observation.T_world_object = T_world_plane * observation.T_world_object;
    belief.observe(observation);
  }
  return belief.worlds();
}

const Marker* find(const MarkerArray& array, const std::string& name) {
  for (const Marker& marker : array.markers) {
    if (marker.ns == name && marker.action == Marker::ADD) return &marker;
  }
  return nullptr;
}

std::multiset<std::tuple<double, double, double>> pointsOf(const Marker& marker) {
  std::multiset<std::tuple<double, double, double>> points;
  for (const auto& point : marker.points) points.insert({point.x, point.y, point.z});
  return points;
}

TEST(PlaceMarkers, AreEachPlaceOnceAndDarkerWhereItIsLikelier) {
  const auto worlds = worldsOfTheWall();
  ASSERT_FALSE(worlds->touched.empty());
  const MarkerArray array = placeMarkers(*worlds, "object");
  const Marker& marker = array.markers.at(0);
  ASSERT_EQ(marker.points.size(), marker.colors.size());
  double sum = 0.0;
  for (const auto& color : marker.colors) sum += 1.0 - color.r / 0.941;
  double expected = 0.0;  // each world that holds a contact to be true has a place for it
  for (const auto& [id, places] : worlds->touched) {
    for (int i = 0; i < kHypotheses; ++i) {
      if (places[i]) expected += SampledWorlds::shareOf(HypothesisMask{1} << i);
    }
  }
  EXPECT_NEAR(sum, expected, 1e-4);
  EXPECT_EQ(marker.header.frame_id, "object");
  EXPECT_TRUE(marker.header.stamp.isZero());
}

TEST(PlaceMarkers, AreTakenAwayWhereNothingWasTouched) {
  const JointBelief belief(planarParameters());
  const MarkerArray array = placeMarkers(*belief.worlds(), "object");
  EXPECT_EQ(array.markers.at(0).action, Marker::DELETE);
}

TEST(SampledWorld, IsTheMatterOfOneWorldOnBothSides) {
  const auto worlds = worldsOfTheWall();
  ASSERT_FALSE(worlds->sampled.parts().empty());
  std::size_t shown = 0;
  std::size_t held = 0;
  for (const WorldsAtUnit& part : worlds->sampled.parts()) {
    for (const MaskedPoint& ball : part.object()) held += __builtin_popcountll(ball.mask);
    for (const MaskedPoint& ball : part.world()) held += __builtin_popcountll(ball.mask);
  }
  for (int number = 1; number <= kHypotheses; ++number) {
    const MarkerArray array = sampledWorldMarkers(*worlds, number, kFrames);
    EXPECT_EQ(array.markers.at(0).action, Marker::DELETEALL);
    for (const char* side : {"touched object", "touched world"}) {
      const Marker* balls = find(array, side);
      ASSERT_NE(balls, nullptr) << side;
      EXPECT_EQ(balls->type, Marker::SPHERE_LIST);
      shown += balls->points.size();
    }
  }
  EXPECT_EQ(shown, held);
}

TEST(SampledWorld, InSpaceHasWhatLiesBehindTheTouchesOfTheObject) {
  JointBelief belief(JointBeliefParameters{});
  for (const ContactObservation& observation : wallObservations()) belief.observe(observation);
  const auto worlds = belief.worlds();
  std::size_t held = 0;
  for (const WorldsAtUnit& part : worlds->sampled.parts()) {
    for (const MaskedPoint& ball : part.behindObject()) held += __builtin_popcountll(ball.mask);
  }
  std::size_t shown = 0;
  for (int number = 1; number <= kHypotheses; ++number) {
    const MarkerArray array = sampledWorldMarkers(*worlds, number, kFrames);
    const Marker* balls = find(array, "object behind touches");
    if (balls != nullptr) shown += balls->points.size();
  }
  EXPECT_GT(shown, 0U);
  EXPECT_EQ(shown, held);
}

TEST(SampledWorld, SaysItsNumber) {
  const MarkerArray array = sampledWorldMarkers(*worldsOfTheWall(), 7, kFrames);
  const Marker* label = find(array, "label");
  ASSERT_NE(label, nullptr);
  EXPECT_EQ(label->text, "world 7 of 64");
}

TEST(SampledWorld, StandsInThePlaneOfMotion) {
  const Pose T_world_plane = makePose({1.0, 2.0, 0.3}, {0.0, 0.0, 0.5});
  const MarkerArray here = sampledWorldMarkers(*worldsOfTheWall(), 1, kFrames);
  const MarkerArray there = sampledWorldMarkers(*worldsOfTheWall(T_world_plane), 1, kFrames);
  const Marker* world = find(there, "touched world");
  ASSERT_NE(world, nullptr);
  EXPECT_EQ(world->header.frame_id, "world");
  const Result<Pose> pose = fromMessage(world->pose);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->isApprox(T_world_plane, 1e-9));
  const Marker* object = find(there, "touched object");
  ASSERT_NE(object, nullptr);
  EXPECT_EQ(object->header.frame_id, "object");
  EXPECT_EQ(object->pose.position.x, 0.0);
  EXPECT_FALSE(pointsOf(*find(here, "touched world")).empty());
}

TEST(SampledWorld, IsTakenAwayWhereNoneIsAskedFor) {
  for (const int number : {-1, 0, kHypotheses + 1, std::numeric_limits<int>::max()}) {
    const MarkerArray array = sampledWorldMarkers(*worldsOfTheWall(), number, kFrames);
    ASSERT_EQ(array.markers.size(), 1U) << number;
    EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
  }
}

TEST(SampledWorld, IsNothingBeforeTheFirstTouch) {
  const JointBelief belief(planarParameters());
  EXPECT_EQ(sampledWorldMarkers(*belief.worlds(), 1, kFrames).markers.size(), 1U);
}

TEST(LineMarkers, HaveTubesOfTwoStandardDeviationsAroundUncertainLines) {
  LineOfAction line;
  line.point = {0.1, 0.2, 0.3};
  line.direction = Vec3(1.0, -2.0, 0.5).normalized();
  line.direction_stddev = 0.05;
  line.offset_stddev = 0.01;
  LineOfAction exact = line;
  exact.direction_stddev = exact.offset_stddev = 0.0;
  const MarkerArray array = lineMarkers({line, exact}, 0.5, 0.03, kFrames);
  EXPECT_EQ(find(array, "lines")->points.size(), 4U);
  const Marker* tube = find(array, "uncertainty");
  ASSERT_NE(tube, nullptr);
  ASSERT_EQ(tube->points.size() % 3, 0U) << "triangles";
  double least = 1.0;
  double most = 0.0;
  for (const auto& point : tube->points) {
    const double distance = distanceToLine(line, {point.x, point.y, point.z});
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  EXPECT_NEAR(least, 0.02, 1e-9) << "in the middle";
  EXPECT_NEAR(most, 2.0 * std::hypot(0.01, 0.05 * 0.5), 1e-9) << "at the ends";
  EXPECT_EQ(find(lineMarkers({exact}, 0.5, 0.03, kFrames), "uncertainty"), nullptr);
}

TEST(GhostMarkers, StandFromTheStartToTheGoalInTheColoursOfTheRisk) {
  Path path;
  std::vector<double> risks;
  for (int i = 0; i <= 100; ++i) {
    path.push_back(makePose({0.01 * i, 0.0, 0.0}));
    risks.push_back(0.01 * i);
  }
  const OccupiedVoxels object{0.03, {{0, 0, 0}, {1, 0, 0}}};
  const MarkerArray array = ghostMarkers(path, risks, object, "world");
  ASSERT_GT(array.markers.size(), 3U);
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  EXPECT_EQ(array.markers[1].pose.position.x, 0.0);
  EXPECT_EQ(array.markers.back().pose.position.x, 1.0);
  for (std::size_t i = 1; i < array.markers.size(); ++i) {
    const Marker& ghost = array.markers[i];
    EXPECT_EQ(ghost.points.size(), 2U);
    EXPECT_EQ(ghost.id, static_cast<int>(i) - 1);
    EXPECT_NEAR(ghost.color.g, riskColor(ghost.pose.position.x).g, 1e-6);
  }
}

TEST(GhostMarkers, AreOnlyTakenAwayWhereTheObjectIsUnknown) {
  const Path path(3, Pose::Identity());
  EXPECT_EQ(ghostMarkers(path, {0.0, 0.0, 0.0}, {0.03, {}}, "world").markers.size(), 1U);
  EXPECT_EQ(ghostMarkers({Pose::Identity()}, {0.0}, {0.03, {{0, 0, 0}}}, "world").markers.size(),
            2U);
}

}  // namespace
}  // namespace smore
