// SPDX-License-Identifier: BSD-3-Clause
// What a mapping node is told while it runs, and what it keeps of one map without the other.
#include <gtest/gtest.h>

#include "../scenario/temporary_directory.h"
#include "keeper_feeding.h"
#include "smore/common/result.h"
#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

// A peg at x = -0.1 m that ends of the object meet from several sides: no doubt where it is.
std::vector<ContactObservation> touchesOfAPeg() {
  std::vector<ContactObservation> observations;
  ContactObservation now;
  for (const double y : {-0.12, -0.06, 0.06, 0.12}) {
    for (const double heading : {0.0, 0.8, 1.6}) {
      const Vec3 end(0.0, y, 0.0);
      now.time += 1.0;
      now.state = ContactState::kContact;
      ++now.contact_id;
      now.T_world_object = makePose(Vec3(-0.1, 0.0, 0.0) - end);
      now.line = LineOfAction{};
      now.line->direction = {std::cos(heading), std::sin(heading), 0.0};
      now.line->point = end;
      now.line->force = 6.0;
      observations.push_back(now);
    }
  }
  return observations;
}

// A wall of one voxel's width, x from -0.18 to -0.15 m, with nothing in front of it.
Prior someWall() {
  Prior wall{VoxelGrid(0.03), 0.9};
  for (std::int16_t y = -6; y < 6; ++y) {
    wall.known.set({-6, y, 0}, 1.0F);
    wall.known.set({-5, y, 0}, 0.0F);
  }
  return wall;
}

std::uint64_t revision(const MapKeeper& keeper) {
  std::uint64_t revision = 0;
  keeper.access([&](const MapState& state) { revision = revisionOf(state); });
  return revision;
}

class ToldKeeper : public testing::Test {
 protected:
  static constexpr MethodKind kMethod = MethodKind::kSmore;

  void expectResumed() const {
    const Evidence evidence = readEvidence(EvidenceJournal::newest(directory_.path()).value());
    MapKeeper resumed(emptyMaps(kMethod), kSpacing);
    resumed.load(evidence.source.priors, evidence.observations);
    expectSameState(keeper_, resumed);
  }

  TemporaryDirectory directory_;
  MapKeeper keeper_{emptyMaps(kMethod), kSpacing,
                    std::make_unique<EvidenceJournal>(directory_.path(), source(kMethod))};
};

TEST_F(ToldKeeper, hasTheSameMapsWheneverItWasTold) {
  feed(&keeper_, touches(1, 0.0, 3));
  const std::uint64_t before = revision(keeper_);
  keeper_.know(MapSide::kWorld, someWall());
  EXPECT_GT(revision(keeper_), before);
  auto after = touches(2, 100.0, 3);
  for (ContactObservation& observation : after) observation.contact_id += 3;
  feed(&keeper_, after);
  MapKeeper told(emptyMaps(kMethod), kSpacing, nullptr, {{}, {someWall()}});
  feed(&told, touches(1, 0.0, 3));
  feed(&told, after);
  expectSameState(told, keeper_);
  expectResumed();
}

TEST_F(ToldKeeper, countsTheSameKnowledgeOnce) {
  feed(&keeper_, touches(1, 0.0, 1));
  keeper_.know(MapSide::kWorld, someWall());
  const std::uint64_t once = revision(keeper_);
  keeper_.know(MapSide::kWorld, someWall());
  EXPECT_EQ(revision(keeper_), once);
  keeper_.know(MapSide::kObject, someWall());
  EXPECT_GT(revision(keeper_), once) << "of the other map it is other knowledge";
}

TEST_F(ToldKeeper, forgetsAtAResetWhatWasToldSinceTheStart) {
  MapKeeper keeper(emptyMaps(kMethod), kSpacing, nullptr, {{}, {someWall()}});
  keeper.know(MapSide::kObject, someWall());
  keeper.reset();
  keeper.access([](const MapState& state) {
    EXPECT_TRUE(state.priors.object.empty());
    EXPECT_EQ(state.priors.world.size(), 1U);
    EXPECT_EQ(state.maps->object().size(), 0U);
    EXPECT_GT(state.maps->world().size(), 0U);
  });
}

TEST_F(ToldKeeper, beginsANewGraspWithAnEmptyObjectMapAndTheWorldThatItKnew) {
  feed(&keeper_, touchesOfAPeg());
  keeper_.know(MapSide::kObject, someWall());
  VoxelGrid learnt(0.03);
  keeper_.access([&](const MapState& state) { learnt = state.maps->world(); });
  const std::uint64_t before = revision(keeper_);
  keeper_.reset(MapSide::kObject);
  EXPECT_GT(revision(keeper_), before);
  int matter = 0;
  keeper_.access([&](const MapState& state) {
    EXPECT_EQ(state.maps->object().size(), 0U);
    EXPECT_TRUE(state.lines.empty());
    EXPECT_EQ(state.log.size(), 0U);
    for (const VoxelGrid::Voxel& voxel : learnt.voxels()) {
      if (voxel.probability < kOccupied || voxel.key.z != 0) continue;
      ++matter;
      EXPECT_TRUE(state.maps->world().find(voxel.key));
    }
  });
  EXPECT_GT(matter, 0);
  expectResumed();
  feed(&keeper_, touches(2, 200.0, 2));
  expectResumed();
}

TEST_F(ToldKeeper, canForgetTheWorldInstead) {
  feed(&keeper_, touchesOfAPeg());
  keeper_.reset(MapSide::kWorld);
  keeper_.access([&](const MapState& state) {
    EXPECT_EQ(state.maps->world().size(), 0U);
    EXPECT_GT(state.maps->object().size(), 0U);
  });
}

TEST_F(ToldKeeper, staysAsItIsWhereItsMapsCannotUseKnowledge) {
  MapKeeper keeper(emptyMaps(MethodKind::kPaper), kSpacing);
  feed(&keeper, touches(1, 0.0, 2));
  MapKeeper untouched(emptyMaps(MethodKind::kPaper), kSpacing);
  feed(&untouched, touches(1, 0.0, 2));
  EXPECT_THROW(keeper.know(MapSide::kWorld, someWall()), InputError);
  EXPECT_THROW(keeper.load({{someWall()}, {}}, {}), InputError);
  expectSameState(untouched, keeper);
}

}  // namespace
}  // namespace smore
