// SPDX-License-Identifier: BSD-3-Clause
// What a mapping node learnt outlives it: journal, loading, observations that do not fit.
#include <gtest/gtest.h>

#include <filesystem>

#include "../scenario/temporary_directory.h"
#include "keeper_feeding.h"
#include "smore/common/result.h"
#include "smore/ros/belief_files.h"

namespace smore {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Methods, KeptEvidence,
                         testing::Values(MethodKind::kPaper, MethodKind::kSmore),
                         [](const auto& method) { return methodName(method.param); });

TEST(MapKeeper, leavesOutAnObservationThatDoesNotFitAndTellsItOnce) {
  MapKeeper keeper(emptyMaps(MethodKind::kSmore), kSpacing);
  ContactObservation far = touches(1, 0.0, 1).front();
  far.T_world_object = makePose({1e6, 0.0, 0.0});
  keeper.push(far);
  feed(&keeper, touches(1, 1.0, 1));
  const std::string problem = keeper.takeProblems().left_out;
  EXPECT_NE(problem.find("outside of the maps"), std::string::npos) << problem;
  EXPECT_EQ(keeper.takeProblems().left_out, "");
  MapKeeper other(emptyMaps(MethodKind::kSmore), kSpacing);
  feed(&other, touches(1, 1.0, 1));
  expectSameState(other, keeper);
}

TEST(MapKeeper, tellsTheEndOfTheJournalWhateverElseGoesWrong) {
  const TemporaryDirectory directory;
  MapKeeper keeper(
      emptyMaps(MethodKind::kSmore), kSpacing,
      std::make_unique<EvidenceJournal>(directory.path() + "/run", source(MethodKind::kSmore)));
  std::filesystem::remove_all(directory.path() + "/run");
  keeper.reset();  // which would begin a new file
  ContactObservation far = touches(1, 0.0, 1).front();
  far.T_world_object = makePose({1e6, 0.0, 0.0});
  feed(&keeper, {far});
  const KeeperProblems problems = keeper.takeProblems();
  EXPECT_NE(problems.journal_end.find("the journal ends here"), std::string::npos);
  EXPECT_NE(problems.left_out.find("outside of the maps"), std::string::npos);
}

// What its thread holds in its hands at a reset is forgotten, too.
TEST(MapKeeper, knowsNothingAfterAResetThatCameBefore) {
  MapKeeper keeper(emptyMaps(MethodKind::kSmore), kSpacing);
  for (int i = 0; i < 100; ++i) {
    std::vector<ContactObservation> observations = touches(i, 100.0 * i, 1);
    for (const ContactObservation& observation : observations) keeper.push(observation);
    const double newest = keeper.arrivals().newest;
    keeper.reset();
    ContactObservation next = observations.back();
    next.time = newest + 1.0;
    keeper.push(next);
    ASSERT_TRUE(keeper.waitFor(next.time, kLongEnough));
    keeper.access([&](const MapState& state) {
      EXPECT_EQ(state.since, newest);
      ASSERT_EQ(state.log.size(), 1U) << "in round " << i;
      EXPECT_EQ(state.log.from(0).front().time, next.time);
    });
  }
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

TEST(BeliefFiles, refusesEvidenceOfAnotherPlane) {
  const TemporaryDirectory directory;
  EvidenceSource lifted = source(MethodKind::kSmore);
  lifted.task.start = makePose({0.0, 0.0, 0.3});
  MapKeeper keeper(emptyMaps(MethodKind::kSmore), kSpacing);
  feed(&keeper, touches(1, 0.0, 1));
  BeliefFiles(directory.path(), source(MethodKind::kSmore)).save(keeper, "flat", false);
  const BeliefFiles other(directory.path(), lifted);
  EXPECT_THROW(other.load("flat", &keeper), InputError);
  EXPECT_NO_THROW(BeliefFiles(directory.path(), source(MethodKind::kSmore)).load("flat", &keeper));
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
