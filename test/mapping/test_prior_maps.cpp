// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../scenario/meshes.h"
#include "../scenario/temporary_directory.h"
#include "prior_scenes.h"

namespace smore {
namespace {

TEST(PriorMaps, TheTruthSaysEverythingInThePlane) {
  const Priors priors = makePriors(sceneWith({{truth()}, {truth()}}));
  EXPECT_EQ(saidAt(priors.object.at(0), {0.041, 0.141, 0.001}), Said::kMatter);
  EXPECT_EQ(saidAt(priors.object.at(0), {0.061, 0.0, 0.001}), Said::kFree);
  EXPECT_EQ(saidAt(priors.object.at(0), {0.0, 0.0, 0.025}), Said::kNothing) << "above the plane";
  EXPECT_EQ(saidAt(priors.world.at(0), {-0.3, 0.1, 0.001}), Said::kMatter);
  EXPECT_EQ(saidAt(priors.world.at(0), {0.3, 0.3, 0.001}), Said::kFree);
  EXPECT_EQ(priors.world.at(0).confidence, 0.999);
}

// Also where it stands upright, and at no axis of the map's: what lies in the plane is known
// everywhere, at the same distances, and nothing far from it.
TEST(PriorMaps, TheTruthSaysEverythingInAPlaneAtAnyAngle) {
  for (const Vec3& rpy : {Vec3(M_PI / 2, 0, 0), Vec3(0, M_PI / 2, 0.3), Vec3(0.5, 0.6, 0.7)}) {
    Scenario scene = sceneWith({{}, {truth()}});
    scene.start = makePose(Vec3(0.1, 0.05, -0.1), rpy);
    scene.environment = {{SphereShape{0.2}, scene.start * makePose(Vec3(-0.3, 0.1, 0.0))}};
    scene.workspace = {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    const Prior prior = makePriors(scene).world.at(0);
    EXPECT_DOUBLE_EQ(prior.known.voxelSize(), 0.01);
    for (double x = -0.6; x <= 0.4; x += 0.0137) {
      for (double y = -0.4; y <= 0.4; y += 0.0171) {
        const Vec3 place = scene.start * Vec3(x, y, 0.0);
        const double depth = 0.2 - std::hypot(x + 0.3, y - 0.1);
        const Said said = saidAt(prior, place);
        ASSERT_NE(said, Said::kNothing) << x << " " << y << ", turned by " << rpy.transpose();
        if (std::abs(depth) > 0.02) {
          EXPECT_EQ(said == Said::kMatter, depth > 0.0) << x << " " << y;
        }
        EXPECT_EQ(saidAt(prior, scene.start * Vec3(x, y, 0.04)), Said::kNothing);
      }
    }
  }
}

// What of a box lies in the plane is asked as finely as its own area allows.
TEST(PriorMaps, AWideFlatBoxIsAsFineInAnUprightPlane) {
  Scenario scene = sceneWith({{}, {truth()}});
  scene.start = makePose(Vec3::Zero(), Vec3(M_PI / 2, 0, 0));
  scene.workspace = {Vec3(-20, -20, -0.1), Vec3(20, 20, 0.1)};
  EXPECT_DOUBLE_EQ(makePriors(scene).world.at(0).known.voxelSize(), 0.01);
}

TEST(PriorMaps, ABoxIsCutOutAndThenMoved) {
  PriorSource half;
  half.box = Bounds{{-0.4, 0.1, -1.0}, {0.0, 1.0, 1.0}};
  half.offset = {0.06, 0.0, 0.0};
  half.confidence = 0.8;
  const Prior prior = makePriors(sceneWith({{}, {half}})).world.at(0);
  EXPECT_EQ(saidAt(prior, {-0.24, 0.121, 0.001}), Said::kMatter);
  EXPECT_EQ(saidAt(prior, {-0.33, 0.121, 0.001}), Said::kFree) << "where the peg ends, moved";
  EXPECT_EQ(saidAt(prior, {-0.24, 0.079, 0.001}), Said::kNothing) << "below the box";
  EXPECT_EQ(saidAt(prior, {0.05, 0.2, 0.001}), Said::kFree) << "in the moved box only";
  EXPECT_EQ(prior.confidence, 0.8);
}

TEST(PriorMaps, AMeshSaysWhatIsInItsOwnBox) {
  TemporaryDirectory directory;
  PriorSource mesh = fromFile(PriorFormat::kMesh, directory.write("cube.obj", cubeObj()));
  mesh.scale = Vec3::Constant(0.1);
  mesh.pose = makePose({0.2, 0.0, -0.05}, {0.0, 0.0, M_PI / 2.0});  // to x from 0.1 to 0.2
  const Prior prior = makePriors(sceneWith({{mesh}, {}})).object.at(0);
  EXPECT_EQ(saidAt(prior, {0.15, 0.05, 0.001}), Said::kMatter);
  EXPECT_EQ(saidAt(prior, {0.15, 0.105, 0.001}), Said::kFree);
  EXPECT_EQ(saidAt(prior, {0.15, 0.15, 0.001}), Said::kNothing);
}

// So large a mesh is told in larger voxels than asked for, and still what is around it is free.
TEST(PriorMaps, ALargeMeshHasFreeSpaceOnAllSides) {
  TemporaryDirectory directory;
  PriorSource mesh = fromFile(PriorFormat::kMesh, directory.write("cube.obj", cubeObj()));
  mesh.scale = Vec3(2.0, 2.0, 1.0);
  Scenario scene = sceneWith({{}, {mesh}});
  scene.motion = Motion::kSpatial;
  scene.voxel_size = 0.01;
  const Prior prior = makePriors(scene).world.at(0);
  const double rim = prior.known.voxelSize();
  EXPECT_GT(rim, 0.0075);
  for (const double side : {-rim, 2.0 + rim}) {
    EXPECT_EQ(saidAt(prior, {side, 1.0, 0.5}), Said::kFree) << side;
    EXPECT_EQ(saidAt(prior, {1.0, side, 0.5}), Said::kFree) << side;
  }
  EXPECT_EQ(saidAt(prior, {1.0, 1.0, -rim}), Said::kFree);
  EXPECT_EQ(saidAt(prior, {1.0, 1.0, 1.0 + rim}), Said::kFree);
}

// A sheet of a millimetre, between two layers of voxels or anywhere: nothing passes it.
TEST(PriorMaps, ThinMatterIsThickenedAndNeverFree) {
  for (const double place : {0.3, 0.302, 0.305, 0.308}) {
    for (const double turn : {0.0, 0.2, 0.4}) {
      Scenario scene = sceneWith({{}, {truth()}});
      scene.workspace = {Vec3(-0.2, -0.2, -0.01), Vec3(0.6, 0.2, 0.01)};
      scene.environment = {
          {BoxShape{Vec3(0.001, 3.0, 0.3)}, makePose(Vec3(place, 0.0, 0.0), Vec3(0, 0, turn))}};
      const Prior prior = makePriors(scene).world.at(0);
      for (double y = -0.3; y < 0.3; y += 0.0017) {
        bool stopped = false;
        for (double x = place - 0.2; x < place + 0.2; x += 0.0023) {
          stopped = stopped || saidAt(prior, {x, y, 0.001}) == Said::kMatter;
        }
        EXPECT_TRUE(stopped) << "at " << place << ", turned by " << turn << ", y " << y;
      }
    }
  }
}

TEST(PriorMaps, ThickMatterIsAsThickAsItIs) {
  const Prior prior = makePriors(sceneWith({{truth()}, {}})).object.at(0);
  int matter = 0;
  for (const VoxelGrid::Voxel& voxel : prior.known.voxels()) matter += voxel.probability > 0.5F;
  EXPECT_EQ(matter, 2 * 10 * 30) << "10 cm by 30 cm, voxels of 1 cm in two layers";
}

// A camera sees the wall behind the room as well.
TEST(PriorMaps, ACloudIsAsFineWithPointsFarAway) {
  PriorSource cloud;
  cloud.format = PriorFormat::kCloud;
  for (double y = -0.05; y < 0.05; y += 0.005) cloud.points.emplace_back(0.105, y, 0.001);
  const Prior near = makePriors(sceneWith({{}, {cloud}})).world.at(0);
  cloud.points.emplace_back(90.0, 60.0, 0.001);
  const Prior prior = makePriors(sceneWith({{}, {cloud}})).world.at(0);
  EXPECT_EQ(prior.known.size(), near.known.size() + 1);
  EXPECT_EQ(saidAt(prior, {0.105, 0.0, 0.001}), Said::kMatter);
}

TEST(PriorMaps, ACloudMayBeInMillimetres) {
  PriorSource cloud;
  cloud.format = PriorFormat::kCloud;
  cloud.points = {{105.0, 5.0, 1.0}};
  cloud.scale = Vec3::Constant(0.001);
  EXPECT_EQ(saidAt(makePriors(sceneWith({{}, {cloud}})).world.at(0), {0.105, 0.005, 0.001}),
            Said::kMatter);
}

TEST(PriorMaps, ACloudSaysWhereItsPointsAreAndNothingElse) {
  TemporaryDirectory directory;
  const PriorSource cloud =
      fromFile(PriorFormat::kCloud,
               directory.write("front.ply",
                               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                               "property float y\nproperty float z\nend_header\n"
                               "0.105 0.005 0.001\n0.205 0.005 0.5\n"));
  const Prior prior = makePriors(sceneWith({{}, {cloud}})).world.at(0);
  EXPECT_EQ(saidAt(prior, {0.105, 0.005, 0.001}), Said::kMatter);
  EXPECT_EQ(saidAt(prior, {0.125, 0.005, 0.001}), Said::kNothing);
  EXPECT_EQ(saidAt(prior, {0.205, 0.005, 0.001}), Said::kNothing) << "above the plane";
}

// As a cloud in millimetres.
TEST(PriorMaps, WhatLiesTooFarIsRefusedWithItsRemedy) {
  PriorSource cloud;
  cloud.format = PriorFormat::kCloud;
  cloud.points = {Vec3(0.1, 0.1, 0.0), Vec3(5000.0, 0.0, 0.0)};
  EXPECT_NE(problemOf(sceneWith({{}, {cloud}})).find("check its scale"), std::string::npos);
}

TEST(PriorMaps, InSpaceLayersAboveThePlaneCountToo) {
  Scenario scene = sceneWith({{truth()}, {}});
  scene.motion = Motion::kSpatial;
  const Prior prior = makePriors(scene).object.at(0);
  EXPECT_EQ(saidAt(prior, {0.0, 0.0, 0.02}), Said::kMatter);
  EXPECT_EQ(saidAt(prior, {0.0, 0.0, 0.05}), Said::kFree);
}

TEST(PriorMaps, WhatSaysNothingIsRefusedWithItsRemedy) {
  PriorSource far;
  far.box = Bounds{{5.0, 5.0, 5.0}, {6.0, 6.0, 6.0}};
  EXPECT_NE(problemOf(sceneWith({{}, {far}})).find("says nothing"), std::string::npos);
  Scenario task = sceneWith({{truth()}, {}});
  task.object.clear();
  task.environment.clear();
  EXPECT_NE(problemOf(task).find("in simulation only"), std::string::npos);
  TemporaryDirectory directory;
  const std::string text = directory.write("map.ot", "no tree");
  EXPECT_NE(problemOf(sceneWith({{}, {fromFile(PriorFormat::kOctree, text)}})).find("OctoMap"),
            std::string::npos);
  const std::string all = problemOf(sceneWith({{far}, {fromFile(PriorFormat::kOctree, text)}}));
  EXPECT_NE(all.find("says nothing"), std::string::npos) << all;
  EXPECT_NE(all.find("OctoMap"), std::string::npos) << all;
}

}  // namespace
}  // namespace smore
