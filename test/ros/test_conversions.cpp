// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "smore/ros/conversions.h"
#include "smore/ros/parameter_source.h"

namespace smore {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RandomPoses {
 public:
  double number() { return std::uniform_real_distribution<double>(-2.0, 2.0)(random_); }
  Vec3 vector() { return {number(), number(), number()}; }
  Pose pose() { return makePose(vector(), 2.0 * vector()); }

 private:
  std::mt19937 random_{7};
};

ContactObservation observationWithLine(RandomPoses* random) {
  ContactObservation observation;
  observation.time = 12.346;
  observation.T_world_object = random->pose();
  observation.state = ContactState::kContact;
  observation.contact_id = 5;
  observation.line =
      LineOfAction{random->vector(), random->vector().normalized(), 7.5, 0.01, 0.02, 0.003};
  return observation;
}

TEST(Conversions, PosesComeBackFromMessagesAndTransforms) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random.pose();
    const Result<Pose> from_message = fromMessage(toMessage(pose));
    ASSERT_TRUE(from_message);
    EXPECT_TRUE(from_message->isApprox(pose, 1e-12));
    const Result<Pose> from_transform = fromTransform(toTransform(pose));
    ASSERT_TRUE(from_transform);
    EXPECT_TRUE(from_transform->isApprox(pose, 1e-12));
  }
}

TEST(Conversions, ACountThatNoIntHoldsIsTheLargestThatOneHolds) {
  EXPECT_EQ(countOf(0), 0);
  EXPECT_EQ(countOf(7), 7);
  for (const std::uint32_t count : {2147483647U, 2147483648U, 4294967295U}) {
    EXPECT_EQ(countOf(count), 2147483647);
  }
}

TEST(Conversions, PosesThatAreNoPosesAreRefused) {
  for (const double bad : {kNan, kInfinity}) {
    geometry_msgs::Pose message = toMessage(Pose::Identity());
    message.position.y = bad;
    EXPECT_FALSE(fromMessage(message));
    message = toMessage(Pose::Identity());
    message.orientation.z = bad;
    EXPECT_FALSE(fromMessage(message));
  }
  EXPECT_FALSE(fromMessage(geometry_msgs::Pose())) << "a quaternion of zeros is no rotation";
  geometry_msgs::Pose long_quaternion = toMessage(Pose::Identity());
  long_quaternion.orientation.w = 1.1;
  EXPECT_FALSE(fromMessage(long_quaternion));
}

TEST(Conversions, APoseInAnotherFrameIsRefusedByName) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = "base";
  message.pose = toMessage(Pose::Identity());
  const Result<Pose> pose = fromMessage(message, "world");
  ASSERT_FALSE(pose);
  EXPECT_NE(pose.reason().find("'base'"), std::string::npos);
  EXPECT_NE(pose.reason().find("'world'"), std::string::npos);
}

TEST(Conversions, WrenchesComeBack) {
  const Wrench wrench{{1.0, -2.0, 3.0}, {0.1, 0.2, -0.3}};
  const Wrench back = fromMessage(toMessage(wrench));
  EXPECT_EQ(back.force, wrench.force);
  EXPECT_EQ(back.torque, wrench.torque);
}

TEST(Conversions, ObservationsComeBackWithAndWithoutLine) {
  RandomPoses random;
  ContactObservation observation = observationWithLine(&random);
  for (const ContactState state :
       {ContactState::kFree, ContactState::kUnsure, ContactState::kContact}) {
    observation.state = state;
    const auto message = toMessage(observation, {"world", "object"});
    EXPECT_EQ(message.header.frame_id, "object");
    EXPECT_EQ(message.world_frame, "world");
    const Result<ContactObservation> back = fromMessage(message);
    ASSERT_TRUE(back);
    EXPECT_DOUBLE_EQ(back->time, observation.time);
    EXPECT_EQ(back->state, state);
    EXPECT_EQ(back->contact_id, observation.contact_id);
    EXPECT_TRUE(back->T_world_object.isApprox(observation.T_world_object, 1e-12));
    ASSERT_TRUE(back->line);
    EXPECT_EQ(back->line->point, observation.line->point);
    EXPECT_EQ(back->line->direction, observation.line->direction);
    EXPECT_EQ(back->line->force, observation.line->force);
    EXPECT_EQ(back->line->pitch, observation.line->pitch);
    EXPECT_EQ(back->line->direction_stddev, observation.line->direction_stddev);
    EXPECT_EQ(back->line->offset_stddev, observation.line->offset_stddev);
  }
  observation.line.reset();
  EXPECT_FALSE(fromMessage(toMessage(observation, {}))->line);
}

TEST(Conversions, ObservationsThatCannotBeAreRefused) {
  RandomPoses random;
  const auto good = toMessage(observationWithLine(&random), {});
  auto bad = good;
  bad.state = 17;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.line.direction.x = kNan;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.line.direction.x += 1.0;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.line.force = 0.0;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.line.offset_stddev = -1.0;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.pose.position.x = kInfinity;
  EXPECT_FALSE(fromMessage(bad));
  bad = good;
  bad.pose.position.x = 2.0 * kFarthestPlace;
  EXPECT_FALSE(fromMessage(bad)) << "no record could be read again";
}

TEST(Conversions, DirectionsOfAboutUnitLengthBecomeOfUnitLength) {
  RandomPoses random;
  auto message = toMessage(observationWithLine(&random), {});
  message.line.direction.x *= 0.995;
  message.line.direction.y *= 0.995;
  message.line.direction.z *= 0.995;
  const Result<ContactObservation> back = fromMessage(message);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->line->direction.norm(), 1.0, 1e-12);
}

TEST(Conversions, TheObservationsTypeOnTheWireIsThePackages) {
  EXPECT_STREQ(ros::message_traits::datatype<smore_msgs::ContactObservation>(),
               "smore/ContactObservation");
}

TEST(Conversions, PathsComeBack) {
  RandomPoses random;
  const Path path = {random.pose(), random.pose(), random.pose()};
  const nav_msgs::Path message = toMessage(path, "world", 3.5);
  EXPECT_EQ(message.header.frame_id, "world");
  const Result<Path> back = fromMessage(message);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), path.size());
  for (size_t i = 0; i < path.size(); ++i) EXPECT_TRUE((*back)[i].isApprox(path[i], 1e-12));
}

TEST(Conversions, TrajectoriesComeBackAsTheyWere) {
  JointTrajectory trajectory;
  trajectory.joint_names = {"one", "two"};
  trajectory.points = {{0.0, {0.1, 0.2}, {0.0, 0.0}}, {1.5, {0.3, -0.2}, {}}};
  const JointTrajectory back = fromMessage(toMessage(trajectory));
  EXPECT_EQ(back.joint_names, trajectory.joint_names);
  ASSERT_EQ(back.points.size(), trajectory.points.size());
  for (size_t i = 0; i < back.points.size(); ++i) {
    EXPECT_DOUBLE_EQ(back.points[i].time, trajectory.points[i].time);
    EXPECT_EQ(back.points[i].positions, trajectory.points[i].positions);
    EXPECT_EQ(back.points[i].velocities, trajectory.points[i].velocities);
  }
}

TEST(Conversions, JointStatesComeInTheOrderAskedForAmongOthers) {
  sensor_msgs::JointState state;
  state.name = {"finger", "two", "one"};
  state.position = {0.5, 2.0, 1.0};
  const auto positions = fromMessage(state, {"one", "two"});
  ASSERT_TRUE(positions);
  EXPECT_EQ(*positions, (std::vector<double>{1.0, 2.0}));
  EXPECT_FALSE(fromMessage(state, {"one", "three"}));
  state.position = {0.5, kNan, 1.0};
  EXPECT_FALSE(fromMessage(state, {"one", "two"}));
  state.position.resize(1);
  EXPECT_FALSE(fromMessage(state, {"one", "two"}));
}

TEST(ParameterSource, ParameterServerValuesBecomeYaml) {
  XmlRpc::XmlRpcValue value;
  value["number"] = 0.1;
  value["count"] = 3;
  value["flag"] = true;
  value["text"] = "paper";
  value["list"][0] = 1.5;
  value["list"][1] = 2;
  value["nested"]["inner"] = -1e-7;
  const YAML::Node yaml = toYaml(value);
  EXPECT_EQ(yaml["number"].as<double>(), 0.1);
  EXPECT_EQ(yaml["count"].as<int>(), 3);
  EXPECT_EQ(yaml["flag"].as<bool>(), true);
  EXPECT_EQ(yaml["text"].as<std::string>(), "paper");
  EXPECT_EQ(yaml["list"][1].as<double>(), 2.0);
  EXPECT_EQ(yaml["nested"]["inner"].as<double>(), -1e-7);
}

TEST(ParameterSource, TheScenarioDecidesAndRefusesAnotherValue) {
  YAML::Node mapping(YAML::NodeType::Map);
  ParameterReader reader(mapping, "/node");
  imposeScenarioValue(mapping, "detector", "contact_force", 5.0, &reader);
  imposeScenarioValue(mapping, "detector", "contact_force", 5.0, &reader);
  EXPECT_EQ(mapping["detector"]["contact_force"].as<double>(), 5.0);
  reader.nested("detector");
  EXPECT_NO_THROW(reader.finish());
  imposeScenarioValue(mapping, "detector", "contact_force", 7.0, &reader);
  try {
    reader.finish();
    FAIL() << "a different value was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/node: detector.contact_force"), std::string::npos);
  }
}

}  // namespace
}  // namespace smore
