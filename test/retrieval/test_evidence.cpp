// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "../common/refusal.h"
#include "../scenario/temporary_directory.h"
#include "smore/common/result.h"
#include "smore/planning/cspace_memory.h"
#include "smore/retrieval/evidence.h"
#include "smore/retrieval/evidence_recorder.h"

namespace smore {
namespace {

bool says(const std::string& message, const std::string& words) {
  return message.find(words) != std::string::npos;
}

Scenario someTask() {
  Scenario task;
  task.name = "some \"task\"";
  task.goal = makePose({-0.4, 0.1, 0.0}, {0.0, 0.0, 0.3});
  task.workspace = {{-0.6, -0.4, -0.01}, {0.2, 0.4, 0.01}};
  task.voxel_size = 0.04;
  task.wrench_noise.force_stddev = 0.1;
  return task;
}

// What a robot might see: it creeps, stands still, jumps, touches, loses contact, says nothing.
std::vector<ContactObservation> randomObservations(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<ContactObservation> observations;
  ContactObservation now;
  now.state = ContactState::kFree;
  for (int i = 0; i < count; ++i) {
    now.time = 0.002 * i;
    now.line.reset();
    const double event = uniform(random);
    if (event < 0.5) {
      now.T_world_object =
          makePose({now.T_world_object.translation().x() + 2e-4 * normal(random),
                    now.T_world_object.translation().y() + 2e-4 * normal(random), 0.0},
                   {0.0, 0.0, 0.3 * uniform(random)});
    } else if (event < 0.52) {
      now.T_world_object =
          makePose({0.3 * (uniform(random) - 0.5), 0.3 * (uniform(random) - 0.5), 0.0});
    } else if (event < 0.57) {
      now.state = static_cast<ContactState>(random() % 3);
      if (now.state == ContactState::kContact) ++now.contact_id;
    } else if (event < 0.6) {
      LineOfAction line;
      const double heading = 6.0 * uniform(random);
      line.direction = {std::cos(heading), std::sin(heading), 0.0};
      line.point = 0.1 * normal(random) * Vec3(-line.direction.y(), line.direction.x(), 0.0);
      line.force = 5.0 + uniform(random);
      line.pitch = 1e-4 * normal(random);
      line.offset_stddev = uniform(random) < 0.5 ? 0.0 : 0.01;
      now.line = line;
    }
    observations.push_back(now);
  }
  return observations;
}

void expectSame(const VoxelGrid& a, const VoxelGrid& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.voxels()[i].key, b.voxels()[i].key);
    EXPECT_EQ(a.voxels()[i].probability, b.voxels()[i].probability);
  }
}

class EvidenceFile : public ::testing::TestWithParam<MethodKind> {
 protected:
  std::string record(const std::vector<ContactObservation>& observations) {
    const std::string file = directory_.path() + "/some.evidence";
    JsonLinesWriter writer(file);
    EvidenceRecorder recorder(&writer, source_);
    recorder.motionBegins({source_.task.start, source_.task.goal}, 0.25);
    for (const ContactObservation& observation : observations) recorder.observe(observation);
    MotionResult result;
    result.end = MotionEnd::kContact;
    result.length = 0.1;
    recorder.motionEnded(result, makePose({0.1, 0.0, 0.0}));
    recorder.motionBegins({source_.task.goal}, std::nullopt);
    recorder.finish({true, "at the goal", 7});
    return file;
  }

  std::string contentOf(const std::string& file) const {
    std::ostringstream content;
    content << std::ifstream(file).rdbuf();
    return content.str();
  }

  // The message of reading `content`; empty where it can be read.
  std::string problemOf(const std::string& content) const {
    return refusalOf([&] { return readEvidence(directory_.write("problem.evidence", content)); });
  }

  TemporaryDirectory directory_;
  EvidenceSource source_{someTask(), GetParam(), {}, 18446744073709551615u, {}};
};

TEST_P(EvidenceFile, makesTheSameMapsBitByBit) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto observations = randomObservations(seed, 1500);
    Method live = makeMethod(source_.method, source_.task, source_.seed, source_.parameters);
    for (const ContactObservation& observation : observations) live.observe(observation);
    const Evidence evidence = readEvidence(record(observations));
    EXPECT_LT(evidence.observations.size(), observations.size()) << "repetitions are left out";
    Method again = makeMethod(evidence.source.method, evidence.source.task, evidence.source.seed,
                              evidence.source.parameters);
    replay(evidence, &again);
    expectSame(live.maps->world(), again.maps->world());
    expectSame(live.maps->object(), again.maps->object());
    if (!live.memory) continue;
    const auto& poses = dynamic_cast<CspaceMemory&>(*live.memory).contactPoses();
    const auto& poses_again = dynamic_cast<CspaceMemory&>(*again.memory).contactPoses();
    ASSERT_EQ(poses.size(), poses_again.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(poses[i].matrix(), poses_again[i].matrix());
    }
  }
}

TEST_P(EvidenceFile, tellsTaskMotionsAndOutcome) {
  source_.parameters.belief.feature.radius = 0.213;
  source_.parameters.planner.iterations = 77;
  const auto observations = randomObservations(4, 300);
  const Evidence evidence = readEvidence(record(observations));
  EXPECT_EQ(evidence.source.method, GetParam());
  EXPECT_EQ(evidence.source.seed, source_.seed);
  EXPECT_EQ(evidence.source.task.name, source_.task.name);
  EXPECT_EQ(evidence.source.task.goal.matrix(), source_.task.goal.matrix());
  EXPECT_EQ(evidence.source.task.voxel_size, 0.04);
  EXPECT_EQ(evidence.source.task.wrench_noise.force_stddev, 0.1);
  if (GetParam() == MethodKind::kSmore) {
    EXPECT_EQ(evidence.source.parameters.belief.feature.radius, 0.213);
    EXPECT_EQ(evidence.source.parameters.planner.iterations, 77);
  }
  ASSERT_EQ(evidence.motions.size(), 2u);
  EXPECT_EQ(evidence.motions[0].path.size(), 2u);
  EXPECT_EQ(evidence.motions[0].risk, 0.25);
  EXPECT_EQ(evidence.motions[0].end, MotionEnd::kContact);
  EXPECT_EQ(evidence.motions[0].observations_before, 0u);
  EXPECT_EQ(evidence.motions[1].observations_before, evidence.observations.size());
  EXPECT_FALSE(evidence.motions[1].risk);
  EXPECT_FALSE(evidence.motions[1].end) << "it had not ended";
  ASSERT_TRUE(evidence.outcome);
  EXPECT_EQ(evidence.outcome->collisions, 7);
}

TEST_P(EvidenceFile, cutAnywhereLoadsItsWholeRecordsOrIsRefused) {
  const std::string content = contentOf(record(randomObservations(5, 200)));
  const std::size_t first_event = [&] {
    std::size_t at = 0;
    for (int line = 0; line < 3; ++line) at = content.find('\n', at) + 1;
    return at;
  }();
  std::mt19937_64 random(6);
  for (int i = 0; i < 50; ++i) {
    // Every second one within the first three records, which are short.
    const std::size_t length = random() % (i % 2 == 0 ? content.size() : first_event + 1);
    const std::string cut = content.substr(0, length);
    if (length < first_event) {
      EXPECT_PRED2(says, problemOf(cut), "before its header, task and method are whole");
      continue;
    }
    const Evidence evidence = readEvidence(directory_.write("cut.evidence", cut));
    std::size_t whole = 0;
    std::istringstream lines(cut.substr(0, cut.rfind('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      if (line.find(R"("record":"observation")") != std::string::npos) ++whole;
    }
    EXPECT_EQ(evidence.observations.size(), whole);
    EXPECT_EQ(evidence.whole, cut.back() == '\n');
  }
}

TEST_P(EvidenceFile, refusesOtherFilesAndNewerOnes) {
  const std::string content = contentOf(record(randomObservations(7, 50)));
  EXPECT_PRED2(says, problemOf(""), "before its header");
  EXPECT_PRED2(says, problemOf("belief: {radius: 1}\n"), "line 1: not a record");
  EXPECT_PRED2(says, problemOf("{\"a\": 1}\n"), "not a file of evidence");
  EXPECT_PRED2(says,
               problemOf(std::string("\x7f"
                                     "ELF\0\0\n\n",
                                     9)),
               ("line 1: not a record"));
  std::string newer = content;
  newer.replace(newer.find("\"version\":2"), 11, "\"version\":9");
  EXPECT_PRED2(says, problemOf(newer), "format version 9");
  EXPECT_PRED2(says, problemOf(newer), "use a newer one");
}

// A world frame far away, or a glitch of tf: what the mapping takes is not lost.
TEST_P(EvidenceFile, readsPosesFarOutsideOfTheWorkspace) {
  std::vector<ContactObservation> observations = randomObservations(8, 50);
  for (ContactObservation& observation : observations)
    observation.T_world_object.pretranslate(Vec3(40, 0, 0));
  EXPECT_EQ(problemOf(contentOf(record(observations))), "");
}

TEST_P(EvidenceFile, refusesDamagedRecordsByTheirLine) {
  const std::string content = contentOf(record(randomObservations(8, 50)));
  const auto damaged = [&](const std::string& from, const std::string& to) {
    std::string text = content;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return problemOf(text.replace(at, from.size(), to));
  };
  EXPECT_PRED2(says, damaged("\"voxel_size\":0.04", "\"voxel_size\":-1"), "line 2: voxel_size");
  EXPECT_PRED2(says, damaged("\"voxel_size\":0.04,", ""), "voxel_size: missing");
  EXPECT_PRED2(says, damaged("\"seed\":1844", "\"seed\":-1844"), "line 3: seed");
  EXPECT_PRED2(says, damaged("\"record\":\"observation\"", "\"record\":\"gossip\""), "'gossip'");
  EXPECT_PRED2(says, damaged("\"state\":\"free\"", "\"state\":\"fine\""), "state: expected one");
  EXPECT_PRED2(says, damaged("\"time\":0.0", "\"time\":nan"), "not a record");
  EXPECT_PRED2(says, damaged("\"time\":0.0", "\"time\":null"), "time: expected a finite number");
  EXPECT_PRED2(says, damaged("\"risk\":0.25", "\"risk\":1.25"), "line 4: risk");
  EXPECT_PRED2(says, damaged("\"pose\":[", "\"pose\":[1,"), "pose: expected 12 numbers");
  for (const std::string key : {"pose", "start"}) {
    std::string far = content;
    const std::size_t at = far.find("\"" + key + "\":[");
    far.replace(at, far.find(']', at) - at, "\"" + key + "\":[1,0,0,9e9,0,1,0,0,0,0,1,0");
    EXPECT_PRED2(says, problemOf(far), key + ": far outside");
  }
}

TEST_P(EvidenceFile, survivesAnyDamagedByte) {
  const std::string content = contentOf(record(randomObservations(9, 60)));
  std::mt19937_64 random(10);
  for (int i = 0; i < 300; ++i) {
    std::string text = content;
    for (int k = 0; k <= i % 3; ++k) text[random() % text.size()] = static_cast<char>(random());
    try {
      const Evidence evidence = readEvidence(directory_.write("byte.evidence", text));
      for (const ContactObservation& observation : evidence.observations) {
        ASSERT_TRUE(isFinite(observation.T_world_object));
      }
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, EvidenceFile,
                         ::testing::Values(MethodKind::kPaper, MethodKind::kCspace,
                                           MethodKind::kSmore),
                         [](const auto& instance) { return methodName(instance.param); });

}  // namespace
}  // namespace smore
