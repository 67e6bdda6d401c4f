// SPDX-License-Identifier: BSD-3-Clause
// What a mapping node learnt outlives it: journal, loading, observations that do not fit.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "../scenario/temporary_directory.h"
#include "smore/common/result.h"
#include "smore/mapping/octomap_export.h"
#include "smore/ros/map_keeper.h"

namespace smore {
namespace {

constexpr double kLongEnough = 20.0;  // [s]; a wait that fails takes this long
constexpr EvidenceSpacing kSpacing{0.003, 0.01};

EvidenceSource source(MethodKind method) {
  EvidenceSource source;
  source.method = method;
  source.task.goal = makePose({-0.3, 0.0, 0.0});
  source.task.workspace = {{-0.5, -0.5, -0.01}, {0.5, 0.5, 0.01}};
  return source;
}

MapKeeper::MakeMaps emptyMaps(MethodKind method) {
  return [method](const Priors& priors) {
    return makeTwinMap(method, source(method).task, 1, {}, priors);
  };
}

// Motions that end at contacts, numbered from 1 on as a listener does that has just been started.
std::vector<ContactObservation> touches(std::uint64_t seed, double begin, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  std::vector<ContactObservation> observations;
  ContactObservation now;
  now.time = begin;
  for (int id = 0; id <= count; ++id) {
    now.line.reset();
    if (id > 0) {
      now.state = ContactState::kContact;
      now.contact_id = id;
      const double heading = 15.0 * uniform(random);
      LineOfAction line;
      line.direction = {std::cos(heading), std::sin(heading), 0.0};
      line.point = uniform(random) * Vec3(-line.direction.y(), line.direction.x(), 0.0);
      line.force = 6.0;
      now.line = line;
      observations.push_back(now);
      now.line.reset();
    }
    now.state = ContactState::kFree;
    const Vec3 from = now.T_world_object.translation();
    const Vec3 to(uniform(random), uniform(random), 0.0);
    for (int step = 1; step <= 10; ++step) {
      now.time += 0.1;
      now.T_world_object = makePose(from + 0.1 * step * (to - from));
      observations.push_back(now);
    }
  }
  return observations;
}

void feed(MapKeeper* keeper, const std::vector<ContactObservation>& observations) {
  for (const ContactObservation& observation : observations) keeper->push(observation);
  ASSERT_TRUE(keeper->waitFor(observations.back().time, kLongEnough));
}

void expectSame(const VoxelGrid& a, const VoxelGrid& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.voxels()[i].key, b.voxels()[i].key);
    EXPECT_EQ(a.voxels()[i].probability, b.voxels()[i].probability);
  }
}

void expectSameState(const MapKeeper& a, const MapKeeper& b) {
  a.access([&](const MapState& one) {
    b.access([&](const MapState& other) {
      expectSame(one.maps->world(), other.maps->world());
      expectSame(one.maps->object(), other.maps->object());
      EXPECT_GT(one.maps->world().size(), 0U);
      EXPECT_EQ(one.log.size(), other.log.size());
      EXPECT_EQ(one.lines.size(), other.lines.size());
      EXPECT_EQ(changesOf(one), changesOf(other));
    });
  });
}

class KeptEvidence : public testing::TestWithParam<MethodKind> {
 protected:
  std::unique_ptr<EvidenceJournal> journal() const {
    return std::make_unique<EvidenceJournal>(directory_.path() + "/run", source(GetParam()));
  }
  std::string newest() const { return EvidenceJournal::newest(directory_.path() + "/run").value(); }

  TemporaryDirectory directory_;
};

TEST_P(KeptEvidence, givesTheSameMapsToTheBitAfterAnySuddenEnd) {
  MapKeeper ended(emptyMaps(GetParam()), kSpacing, journal());
  feed(&ended, touches(1, 0.0, 4));
  MapKeeper resumed(emptyMaps(GetParam()), kSpacing);
  resumed.load({}, readEvidence(newest()).observations);  // while the first one has its file open
  expectSameState(ended, resumed);
}

TEST_P(KeptEvidence, goesOnWhereItEnded) {
  const auto before = touches(1, 0.0, 3);
  auto after = touches(2, 100.0, 3);
  MapKeeper resumed(emptyMaps(GetParam()), kSpacing);
  resumed.load({}, before);
  feed(&resumed, after);

  MapKeeper all(emptyMaps(GetParam()), kSpacing);
  feed(&all, before);
  for (ContactObservation& observation : after) observation.contact_id += 3;
  feed(&all, after);
  expectSameState(all, resumed);
}

TEST_P(KeptEvidence, staysAsItIsWhereWhatIsLoadedDoesNotFit) {
  MapKeeper keeper(emptyMaps(GetParam()), kSpacing, journal());
  feed(&keeper, touches(1, 0.0, 2));
  MapKeeper untouched(emptyMaps(GetParam()), kSpacing);
  feed(&untouched, touches(1, 0.0, 2));
  std::vector<ContactObservation> foreign = touches(2, 0.0, 2);
  for (ContactObservation& observation : foreign) {
    observation.T_world_object.translation().x() += 1e6;
  }
  EXPECT_THROW(keeper.load({}, foreign), InputError);
  expectSameState(untouched, keeper);
}

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

INSTANTIATE_TEST_SUITE_P(Methods, KeptEvidence,
                         testing::Values(MethodKind::kPaper, MethodKind::kSmore),
                         [](const auto& method) { return methodName(method.param); });

TEST(MapKeeper, leavesOutAnObservationThatDoesNotFitAndTellsItOnce) {
  MapKeeper keeper(emptyMaps(MethodKind::kSmore), kSpacing);
  ContactObservation far = touches(1, 0.0, 1).front();
  far.T_world_object = makePose({1e6, 0.0, 0.0});
  keeper.push(far);
  feed(&keeper, touches(1, 1.0, 1));
  const auto problem = keeper.takeProblem();
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("outside of the maps"), std::string::npos) << *problem;
  EXPECT_FALSE(keeper.takeProblem());
  MapKeeper other(emptyMaps(MethodKind::kSmore), kSpacing);
  feed(&other, touches(1, 1.0, 1));
  expectSameState(other, keeper);
}

TEST(MapKeeper, beginsANewFileWithEachReset) {
  const TemporaryDirectory directory;
  MapKeeper keeper(emptyMaps(MethodKind::kSmore), kSpacing,
                   std::make_unique<EvidenceJournal>(directory.path(), source(MethodKind::kSmore)));
  feed(&keeper, touches(1, 0.0, 2));
  const std::string first = EvidenceJournal::newest(directory.path()).value();
  keeper.reset();
  const std::string second = EvidenceJournal::newest(directory.path()).value();
  EXPECT_NE(first, second);
  EXPECT_GT(readEvidence(first).observations.size(), 0U);
  EXPECT_EQ(readEvidence(second).observations.size(), 0U);
}

TEST(EvidenceJournal, tellsADirectoryThatCannotBeMade) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("file", "");
  EXPECT_THROW(EvidenceJournal(file + "/below", source(MethodKind::kSmore)), std::runtime_error);
}

TEST(EvidenceJournal, findsTheNewestOfMoreThanNineFilesAndNothingElse) {
  const TemporaryDirectory directory;
  EXPECT_FALSE(EvidenceJournal::newest(directory.path()));
  EXPECT_FALSE(EvidenceJournal::newest(directory.path() + "/missing"));
  EvidenceJournal journal(directory.path(), source(MethodKind::kSmore));
  for (int i = 0; i < 11; ++i) journal.begin({}, {});
  directory.write("99.evidence.part", "");
  directory.write("x100.evidence", "");
  EXPECT_EQ(EvidenceJournal::newest(directory.path()), directory.path() + "/11.evidence");
}

TEST(ContactNumbering, keepsTheNumbersOfAListenerThatIsStartedAnewApart) {
  ContactNumbering numbering;
  std::vector<int> numbers;
  for (const int id : {0, 1, 1, 2, 0, 0, 1, 2, 3, 0, 1}) numbers.push_back(numbering.numberOf(id));
  EXPECT_EQ(numbers, (std::vector<int>{0, 1, 1, 2, 2, 2, 3, 4, 5, 5, 6}));
  numbering.continueAfter(20);
  EXPECT_GT(numbering.numberOf(2), 20);
}

}  // namespace
}  // namespace smore
