// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "at_a_decimetre.h"
#include "smore/mapping/free_space_evidence.h"

namespace smore {
namespace {

constexpr int kContacts = 12;
constexpr int kPoses = 240;

// Contacts and free poses at random within the reach of each other, so that many places of the one
// lie just where balls touch at the others.
struct Observed {
  explicit Observed(unsigned seed) : engine(seed) {
    for (int k = 0; k < kContacts; ++k) contacts.push_back(contact());
    for (int k = 0; k < kPoses; ++k) poses.push_back(pose());
  }

  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine); }
  Vec3 any() { return {uniform(), uniform(), uniform()}; }
  Pose pose() { return makePose(0.5 * any(), 2.0 * any()); }

  ContactHypotheses contact() {
    LineOfAction line;
    line.point = 0.1 * any();
    line.direction = any().normalized();
    line.point -= line.point.dot(line.direction) * line.direction;
    return *contactHypotheses(pose(), line, lengths.feature, false);
  }

  JointBeliefParameters lengths = atADecimetre();
  std::mt19937 engine;
  std::vector<ContactHypotheses> contacts;
  std::vector<Pose> poses;
};

using Conflicts = std::vector<std::array<CandidateBits, kCandidates>>;

enum class Comes { kContactsFirst, kPosesFirst, kPosesAtOnce };

Conflicts conflictsOf(const Observed& observed, Comes order) {
  FreeSpaceEvidence evidence(observed.lengths.free_space,
                             observed.lengths.feature.conflictDistance());
  const auto add_poses = [&] {
    for (const Pose& pose : observed.poses) evidence.addPose(pose);
  };
  if (order == Comes::kPosesFirst) add_poses();
  for (int k = 0; k < kContacts; ++k) evidence.insertContact(k, observed.contacts[k]);
  if (order == Comes::kContactsFirst) add_poses();
  if (order == Comes::kPosesAtOnce) evidence.addPoses(observed.poses);
  Conflicts result;
  for (int k = 0; k < kContacts; ++k) {
    for (int l = 0; l < kContacts; ++l) {
      const ConflictTable* table = evidence.conflicts(k, l);
      result.push_back(table != nullptr ? table->by_object : ConflictTable{}.by_object);
    }
  }
  return result;
}

// To the last bit: rounding decides in the same way whether a pose or a contact came later.
TEST(FreeSpaceEvidence, IsTheSameWhicheverCameFirst) {
  int found = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Observed observed(seed);
    const Conflicts conflicts = conflictsOf(observed, Comes::kContactsFirst);
    EXPECT_EQ(conflicts, conflictsOf(observed, Comes::kPosesFirst)) << "seed " << seed;
    EXPECT_EQ(conflicts, conflictsOf(observed, Comes::kPosesAtOnce)) << "seed " << seed;
    for (const auto& table : conflicts) found += table != ConflictTable{}.by_object ? 1 : 0;
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
}  // namespace smore
