// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "distance_to_line.h"
#include "smore/contact/contact_sensing.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;

// A still robot whose wrench is set by hand.
class ContactSensingTest : public ::testing::Test {
 protected:
  ContactSensingTest() : sensing_(parameters()) { hold({}, 200); }

  static ContactSensingParameters parameters() {
    ContactSensingParameters parameters;
    parameters.tare.samples = 50;
    return parameters;
  }

  std::vector<ContactObservation> hold(const Wrench& contact, int samples) {
    std::vector<ContactObservation> observations;
    for (int i = 0; i < samples; ++i) {
      WrenchSample sample;
      sample.time = kPeriod * ++n_;
      sample.wrench = {contact.force + bias_.force, contact.torque + bias_.torque};
      const auto observation = sensing_.process(sample);
      EXPECT_TRUE(observation);
      observations.push_back(*observation);
      if (sensing_.endedWithoutLine()) ++lineless_;
    }
    return observations;
  }

  static std::vector<LineOfAction> linesOf(const std::vector<ContactObservation>& observations) {
    std::vector<LineOfAction> lines;
    for (const auto& observation : observations) {
      if (observation.line) lines.push_back(*observation.line);
    }
    return lines;
  }

  const Wrench bias_{Vec3(3, -2, 1), Vec3(0.1, 0.2, 0.3)};
  ContactSensing sensing_;
  int n_ = 0;
  int lineless_ = 0;  ///< contacts that ended without a line
};

TEST_F(ContactSensingTest, givesOneLineInEachContactThroughTheContactPoint) {
  const Vec3 contact(0.1, 0.25, 0.02);
  const Vec3 force(8, 3, -1);
  for (int touch = 1; touch <= 3; ++touch) {
    const auto observations = hold({force, contact.cross(force)}, 300);
    const auto lines = linesOf(observations);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(distanceToLine(lines[0], contact), 0.0, 1e-9);
    EXPECT_EQ(observations.back().state, ContactState::kContact);
    EXPECT_EQ(observations.back().contact_id, touch);
    const auto after = hold({}, 100);
    EXPECT_TRUE(linesOf(after).empty());
    EXPECT_EQ(after.back().state, ContactState::kFree);
  }
}

TEST_F(ContactSensingTest, leavesInertiaOutOfTheLine) {
  // The impact's force points elsewhere; only what lasts may count.
  hold({Vec3(0, 30, 0), Vec3::Zero()}, 10);
  const auto lines = linesOf(hold({Vec3(10, 0, 0), Vec3::Zero()}, 100));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].direction.isApprox(Vec3(1, 0, 0), 1e-9));
}

// As a heavy thing that bounces off.
TEST_F(ContactSensingTest, tellsOnceOfEachContactThatEndedBeforeItGaveALine) {
  const Wrench push{Vec3(8, 0, 0), Vec3::Zero()};
  for (int touch = 1; touch <= 2; ++touch) {
    EXPECT_EQ(hold(push, 12).back().contact_id, touch);
    EXPECT_EQ(lineless_, touch - 1) << "it lasts still";
    EXPECT_TRUE(linesOf(hold({}, 50)).empty());
    EXPECT_EQ(lineless_, touch);
  }
  for (const int samples : {24, 300}) {  // less than a whole average, and more
    std::size_t lines = linesOf(hold(push, samples)).size();
    lines += linesOf(hold({}, 50)).size();
    EXPECT_EQ(lines, 1u);
    EXPECT_EQ(lineless_, 2);
  }
}

// As a heavy thing that presses on after it has swung back from the stop.
TEST_F(ContactSensingTest, givesTheLineOfAContactThatSwingsThroughNoForce) {
  hold({Vec3(11, 1, 0), Vec3::Zero()}, 6);
  for (const double force : {-12.0, -8.0, -4.5, -1.6, 0.6, 2.0, 3.0, 3.6}) {
    EXPECT_EQ(hold({Vec3(force, 0, 0), Vec3::Zero()}, 1).back().state, ContactState::kContact);
  }
  const auto lines = linesOf(hold({Vec3(4, 3, 0), Vec3::Zero()}, 50));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].direction.isApprox(Vec3(0.8, 0.6, 0), 1e-9));
  EXPECT_EQ(lineless_, 0);
}

TEST_F(ContactSensingTest, saysUnsureWhileItTares) {
  sensing_.startTare();
  const auto observations = hold({}, 49);
  EXPECT_FALSE(sensing_.tared());
  for (const auto& observation : observations) {
    EXPECT_EQ(observation.state, ContactState::kUnsure);
  }
  hold({}, 1);
  EXPECT_TRUE(sensing_.tared());
}

TEST_F(ContactSensingTest, claimsNothingFromASuspensionUntilTheTareHoweverTheForceSteps) {
  sensing_.suspend();
  for (const auto& observation : hold({Vec3(0, 0, 20), Vec3::Zero()}, 200)) {
    EXPECT_EQ(observation.state, ContactState::kUnsure);
  }
  EXPECT_FALSE(sensing_.tared());
  sensing_.startTare();
  const auto observations = hold({Vec3(0, 0, 20), Vec3::Zero()}, 100);
  EXPECT_EQ(observations.back().state, ContactState::kFree);
  EXPECT_EQ(observations.back().contact_id, 0);
}

// A robot that knows the number of its last contact would take a lower one for a new contact.
TEST_F(ContactSensingTest, keepsTheNumberOfContactsWhileItTares) {
  hold({Vec3(10, 0, 0), Vec3::Zero()}, 100);
  hold({}, 200);
  sensing_.startTare();
  for (const auto& observation : hold({}, 100)) EXPECT_EQ(observation.contact_id, 1);
}

// Where a sensor is zeroed at its driver a weight may press that was gripped just now.
TEST_F(ContactSensingTest, objectsToAZeroingUnderWhatIsNoWeight) {
  hold({}, 300);
  EXPECT_EQ(sensing_.zeroingObjection(), "");
  hold({Vec3(0, 0, -12), Vec3::Zero()}, 300);
  EXPECT_NE(sensing_.tareObjection(), "");
  EXPECT_EQ(sensing_.zeroingObjection(), "");
  hold({Vec3(12, 0, 0), Vec3::Zero()}, 300);
  EXPECT_NE(sensing_.zeroingObjection().find("presses with 12 N"), std::string::npos);
  hold({Vec3(4, 0, 0), Vec3::Zero()}, 300);
  EXPECT_NE(sensing_.zeroingObjection().find("presses with 4 N"), std::string::npos)
      << "as a soft thing does after a while";
}

// Two kilograms that the tare did not know of, in the grip turned by 30 degrees since.
TEST_F(ContactSensingTest, doesNotObjectToAZeroingForAWeightThatHasTurnedSinceTheTare) {
  constexpr double kMass = 2.0;
  WrenchSample sample;
  const auto hold_at = [&](double tilt, const Vec3& press) {
    for (int i = 0; i < 600; ++i) {
      sample.time = kPeriod * ++n_;
      sample.T_world_object = makePose(Vec3::Zero(), Vec3(tilt, 0, 0));
      sample.wrench = bias_;
      sample.wrench.force += kMass * gravityIn(sample.T_world_object) + press;
      ASSERT_TRUE(sensing_.process(sample));
    }
  };
  sensing_.startTare();
  hold_at(0.0, Vec3::Zero());
  hold_at(M_PI / 6, Vec3::Zero());
  EXPECT_NE(sensing_.tareObjection(), "");
  EXPECT_EQ(sensing_.zeroingObjection(), "");
  hold_at(M_PI / 6, Vec3(8, 0, 0));
  EXPECT_NE(sensing_.zeroingObjection().find("presses with 8 N"), std::string::npos);
}

TEST_F(ContactSensingTest, objectsToATareOfARobotThatMovesAsInAFirstRun) {
  WrenchSample sample;
  for (int i = 0; i < 2000; ++i) {
    sample.time = kPeriod * ++n_;
    sample.wrench = bias_;
    sample.T_world_object.translation().x() += 0.002 * kPeriod;  // [m]
    ASSERT_TRUE(sensing_.process(sample));
    if (i > 500) {
      ASSERT_NE(sensing_.tareObjection(), "") << i;
    }
  }
}

// The driver drops out in the middle of the tare: what it felt before is of another place, say.
TEST_F(ContactSensingTest, aTareBeginsAnewAfterASilence) {
  sensing_.startTare();
  hold({Vec3(2, 0, 0), Vec3::Zero()}, 25);
  n_ += 1500;
  EXPECT_EQ(hold({}, 49).back().state, ContactState::kUnsure) << "one sample is missing";
  hold({}, 200);
  EXPECT_TRUE(sensing_.tared());
  EXPECT_LT(sensing_.compensated().force.norm(), 1e-9);
}

TEST_F(ContactSensingTest, aLineIsNotOfWhatWasFeltBeforeASilence) {
  const Wrench before{Vec3(10, 0, 0), Vec3::Zero()};
  const Wrench after{Vec3(0, 10, 0), Vec3::Zero()};
  EXPECT_TRUE(linesOf(hold(before, 22)).empty()) << "its average has begun";
  n_ += 200;
  const auto lines = linesOf(hold(after, 100));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].direction.isApprox(Vec3(0, 1, 0), 1e-9));
}

TEST_F(ContactSensingTest, objectsToATareOfARobotThatMoves) {
  hold({}, 250);
  EXPECT_EQ(sensing_.tareObjection(), "");
  WrenchSample sample;
  for (int i = 0; i < 100; ++i) {
    sample.time = kPeriod * ++n_;
    sample.wrench = bias_;
    sample.T_world_object.translation().x() += 0.02 * kPeriod;  // [m]
    ASSERT_TRUE(sensing_.process(sample));
  }
  EXPECT_NE(sensing_.tareObjection().find("the robot moves"), std::string::npos);
  for (int i = 0; i < 400; ++i) {
    sample.time = kPeriod * ++n_;
    sample.T_world_object.translation().x() += i % 2 == 0 ? 2e-4 : -2e-4;  // tf is noisy
    ASSERT_TRUE(sensing_.process(sample));
  }
  EXPECT_EQ(sensing_.tareObjection(), "");
}

// A weight that was unknown is felt, and is no objection to its own identification.
TEST_F(ContactSensingTest, objectsToAPayloadWhileMoreThanItsWeightPresses) {
  IdentifiedPayload found;
  found.payload.mass = 1.4;
  const Vec3 weight = found.payload.mass * gravityIn(Pose::Identity());
  found.sensor_bias.force = bias_.force;
  hold({weight, Vec3::Zero()}, 100);
  EXPECT_EQ(sensing_.payloadObjection(found), "");
  hold({weight + Vec3(0, 0, 20), Vec3::Zero()}, 100);
  EXPECT_NE(sensing_.payloadObjection(found).find("presses with 20 N"), std::string::npos);
}

TEST_F(ContactSensingTest, leavesBadSamplesOutAndGoesOn) {
  WrenchSample bad;
  bad.time = kPeriod * ++n_;
  bad.wrench.force.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sensing_.process(bad));
  WrenchSample old;
  old.time = kPeriod;
  EXPECT_FALSE(sensing_.process(old));
  EXPECT_EQ(hold({}, 1).back().state, ContactState::kFree);
}

// Five kilograms may hang at the wrist, two do; nobody has said so.
TEST(ContactSensing, feelsNoContactInAWeightThatItDoesNotKnow) {
  ContactSensingParameters parameters;
  parameters.payload.unknown_mass = 5.0;
  ContactSensing sensing(parameters);
  int n = 0;
  const auto hold = [&](double tilt, const Vec3& contact) {
    ContactObservation last;
    for (int i = 0; i < 200; ++i) {
      WrenchSample sample;
      sample.time = kPeriod * ++n;
      sample.T_world_object = makePose(Vec3::Zero(), Vec3(tilt, 0, 0));
      sample.wrench.force = 2.0 * gravityIn(sample.T_world_object) + contact;
      last = *sensing.process(sample);
      EXPECT_FALSE(last.line && tilt != 0.0) << "through contact and weight";
    }
    return last.state;
  };
  EXPECT_EQ(hold(0.0, Vec3::Zero()), ContactState::kFree);
  EXPECT_EQ(hold(0.35, Vec3::Zero()), ContactState::kUnsure);
  EXPECT_EQ(hold(0.35, Vec3(0, 30, 0)), ContactState::kContact);
  EXPECT_EQ(hold(0.0, Vec3::Zero()), ContactState::kFree);
  EXPECT_EQ(hold(0.0, Vec3(0, 6, 0)), ContactState::kContact);

  sensing.setPayload({2.0, Vec3::Zero()});
  EXPECT_EQ(hold(0.0, Vec3::Zero()), ContactState::kFree);
  EXPECT_EQ(hold(0.35, Vec3::Zero()), ContactState::kFree);
}

TEST(ReadContactSensingParameters, refusesThresholdsInTheWrongOrder) {
  const auto yaml = YAML::Load(
      "{tare: {samples: 10, max_force_stddev: 1, max_torque_stddev: 1},"
      " detector: {contact_force: 5, free_force: 6, release_force: 7, dwell: 0, fast_window: 0,"
      " slow_window: 0}, noise: {force_stddev: 0, torque_stddev: 0, force_drift: 0,"
      " sample_period: 0.002, filter_time_constant: 0},"
      " line: {settle: 0, window: 0, min_force: 1, added_direction_stddev: 0, added_offset_stddev: "
      "0}}");
  ParameterReader reader(yaml, "force_torque.yaml");
  readContactSensingParameters(&reader);
  try {
    reader.finish();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("detector.free_force"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("detector.release_force"), std::string::npos);
  }
}

}  // namespace
}  // namespace smore
