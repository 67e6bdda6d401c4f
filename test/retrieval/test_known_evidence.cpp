// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../scenario/temporary_directory.h"
#include "smore/common/result.h"
#include "smore/retrieval/evidence.h"
#include "smore/retrieval/evidence_recorder.h"

namespace smore {
namespace {

// A block of matter with free space around it, in voxels of a centimetre.
Prior someKnowledge(int width) {
  Prior prior{VoxelGrid(0.01), 0.9};
  for (int x = -3; x < width + 3; ++x) {
    for (int y = -5; y < 5; ++y) {
      const bool matter = x >= 0 && x < width && y >= -2 && y < 2;
      const VoxelKey key{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0};
      prior.known.set(key, matter ? 1.0F : 0.0F);
    }
  }
  return prior;
}

EvidenceSource someSource() {
  EvidenceSource source;
  source.task.name = "known";
  source.task.goal = makePose({-0.4, 0.1, 0.0});
  source.task.workspace = {{-0.6, -0.4, -0.01}, {0.2, 0.4, 0.01}};
  source.priors.object = {someKnowledge(4), someKnowledge(20)};
  source.priors.world = {someKnowledge(7)};
  return source;
}

// Free on a way, then touched at its end, three times.
std::vector<ContactObservation> someObservations() {
  std::vector<ContactObservation> observations;
  for (int touch = 1; touch <= 3; ++touch) {
    ContactObservation now;
    now.state = ContactState::kFree;
    now.contact_id = touch - 1;
    for (int i = 0; i < 20; ++i) {
      now.time += 0.002;
      now.T_world_object = makePose({-0.01 * i, 0.02 * touch, 0.0});
      observations.push_back(now);
    }
    now.state = ContactState::kContact;
    now.contact_id = touch;
    now.line = LineOfAction();
    now.line->direction = Vec3::UnitX();
    now.line->point = {0.0, 0.01 * touch, 0.0};
    now.line->force = 5.0;
    observations.push_back(now);
  }
  return observations;
}

class KnownEvidence : public ::testing::Test {
 protected:
  std::string record() const {
    std::string file = directory_.path() + "/some.evidence";
    JsonLinesWriter writer(file);
    EvidenceRecorder recorder(&writer, source_);
    for (const ContactObservation& observation : someObservations()) recorder.observe(observation);
    return file;
  }

  // The message of reading what was recorded with `from` replaced.
  std::string problemWith(const std::string& from, const std::string& to) const {
    std::ostringstream content;
    content << std::ifstream(record()).rdbuf();
    std::string text = content.str();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      readEvidence(directory_.write("problem.evidence", text.replace(at, from.size(), to)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryDirectory directory_;
  EvidenceSource source_ = someSource();
};

Method methodOf(const EvidenceSource& source) {
  return makeMethod(source.method, source.task, source.seed, source.parameters, source.priors);
}

void expectSame(const VoxelGrid& a, const VoxelGrid& b) {
  EXPECT_GT(a.size(), 0U);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.voxels()[i].key, b.voxels()[i].key);
    EXPECT_EQ(a.voxels()[i].probability, b.voxels()[i].probability);
  }
}

TEST_F(KnownEvidence, isReadAsItWasWrittenAndMakesTheSameMaps) {
  Method live = methodOf(source_);
  for (const ContactObservation& observation : someObservations()) live.observe(observation);
  const Evidence evidence = readEvidence(record());
  const Priors& read = evidence.source.priors;
  EXPECT_TRUE(areTheSame(read.object.at(0), source_.priors.object.at(0)));
  EXPECT_TRUE(areTheSame(read.object.at(1), source_.priors.object.at(1)));
  EXPECT_TRUE(areTheSame(read.world.at(0), source_.priors.world.at(0)));
  Method again = methodOf(evidence.source);
  replay(evidence, &again);
  expectSame(live.maps->world(), again.maps->world());
  expectSame(live.maps->object(), again.maps->object());
}

TEST_F(KnownEvidence, otherKnowledgeIsNotTheSame) {
  const Prior& one = source_.priors.world.front();
  Prior other = one;
  EXPECT_TRUE(areTheSame(other, one));
  other.confidence = 0.8;
  EXPECT_FALSE(areTheSame(other, one));
  other = one;
  other.known.set({0, 0, 0}, 0.0F);
  EXPECT_FALSE(areTheSame(other, one));
  EXPECT_FALSE(areTheSame(source_.priors.object.at(0), source_.priors.object.at(1)));
}

TEST_F(KnownEvidence, isRefusedWhereItsRecordIsDamaged) {
  const auto expect = [&](const std::string& from, const std::string& to, const std::string& says) {
    const std::string problem = problemWith(from, to);
    EXPECT_NE(problem.find(says), std::string::npos) << problem;
  };
  expect(R"("map":"object")", R"("map":"moon")", "line 4: map");
  expect("\"confidence\":0.9", "\"confidence\":1.0", "confidence");
  expect("\"matter\":[0,", "\"matter\":[", "matter: expected runs");
  expect("\"matter\":[0,", "\"matter\":[0.5,", "matter: expected runs");
  expect("\"matter\":[0,", "\"matter\":[32767,", "in the range of voxels");
}

TEST_F(KnownEvidence, isRefusedByMethodsThatCannotUseIt) {
  for (const MethodKind kind : {MethodKind::kPaper, MethodKind::kCspace, MethodKind::kBlocked}) {
    EXPECT_THROW((void)makeMethod(kind, source_.task, 1, {}, source_.priors), InputError);
    EXPECT_THROW((void)makeTwinMap(kind, source_.task, 1, {}, source_.priors), InputError);
  }
}

TEST_F(KnownEvidence, ofTheObjectAloneIsWhatChsMustBeTold) {
  Priors told = source_.priors;
  EXPECT_THROW(checkPriors(MethodKind::kChs, told), InputError) << "of the world as well";
  told.world.clear();
  EXPECT_NO_THROW(checkPriors(MethodKind::kChs, told));
  told.object.clear();
  EXPECT_THROW(checkPriors(MethodKind::kChs, told), InputError) << "nothing at all";
}

}  // namespace
}  // namespace smore
