// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "../contact/distance_to_line.h"
#include "at_a_decimetre.h"
#include "smore/mapping/contact_hypotheses.h"

namespace smore {
namespace {

LineOfAction lineAlong(const Vec3& direction, const Vec3& through) {
  LineOfAction line;
  line.direction = direction.normalized();
  line.point = through - through.dot(line.direction) * line.direction;
  line.force = 5.0;
  return line;
}

// Mean and mean square of what the places' displacements from the line are in units of what the
// line states, in the direction `across`.
struct Moments {
  double mean = 0.0;
  double square = 0.0;
};

Moments displacement(const ContactHypotheses& contact, const LineOfAction& line, const Vec3& across,
                     const FeatureParameters& parameters) {
  Moments moments;
  for (int i = 0; i < contact.count; ++i) {
    const Vec3 place = contact.object.at(i).cast<double>() -
                       parameters.radius * contact.object_normal.at(i).cast<double>();
    const Vec3 from_foot = place - line.point;
    const double along = from_foot.dot(line.direction);
    const double stddev = std::hypot(line.offset_stddev, along * line.direction_stddev);
    const double value = from_foot.dot(across) / stddev;
    moments.mean += value / contact.count;
    moments.square += value * value / contact.count;
  }
  return moments;
}

TEST(ContactHypotheses, LieOnAnExactLine) {
  const FeatureParameters parameters = atADecimetre().feature;
  const LineOfAction line = lineAlong({1, 2, 0}, {0.1, 0, 0});
  const auto contact = contactHypotheses(makePose({0.3, 0, 0}), line, parameters, true);
  ASSERT_TRUE(contact);
  double sum = 0.0;
  for (int i = 0; i < contact->count; ++i) {
    const Vec3 object = contact->object.at(i).cast<double>();
    const Vec3 world = contact->world.at(i).cast<double>() - Vec3(0.3, 0, 0);
    EXPECT_LT(distanceToLine(line, object), 1e-6);
    EXPECT_LT((object - world - 2.0 * parameters.radius * line.direction).norm(), 1e-6);
    EXPECT_LE((object - parameters.radius * line.direction).norm(), parameters.reach + 1e-6);
    sum += std::exp(contact->log_prior[i]);
  }
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

// The line is turned by less than a tenth of a radian, so that sines are angles to half a percent.
TEST(ContactHypotheses, ScatterAsTheLineStates) {
  const FeatureParameters parameters = atADecimetre().feature;
  LineOfAction line = lineAlong({1, 0.5, 0}, {0.0, 0.1, 0});
  line.offset_stddev = 0.02;
  line.direction_stddev = 0.08;
  const Vec3 in_plane(-line.direction.y(), line.direction.x(), 0.0);
  for (const bool planar : {true, false}) {
    const auto contact = contactHypotheses(Pose::Identity(), line, parameters, planar);
    ASSERT_TRUE(contact);
    const Moments beside = displacement(*contact, line, in_plane, parameters);
    const Moments above = displacement(*contact, line, Vec3::UnitZ(), parameters);
    EXPECT_NEAR(beside.mean, 0.0, 0.1);
    EXPECT_NEAR(beside.square, 1.0, 0.15);
    EXPECT_NEAR(above.mean, 0.0, 0.1);
    EXPECT_NEAR(above.square, planar ? 0.0 : 1.0, 0.15);
  }
}

TEST(ContactHypotheses, APitchIsAnErrorOfTheOffset) {
  const FeatureParameters parameters = atADecimetre().feature;
  LineOfAction stated = lineAlong({1, 0, 0}, {0, 0.1, 0});
  LineOfAction pitched = stated;
  stated.offset_stddev = 0.03;
  pitched.pitch = -0.03;
  const auto a = contactHypotheses(Pose::Identity(), stated, parameters, false);
  const auto b = contactHypotheses(Pose::Identity(), pitched, parameters, false);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->object.y, b->object.y);
}

// However fast touches grow rarer with the distance: the nearest places are left.
TEST(ContactHypotheses, AreNormalisedWhereTheirWeightsAreTooSmallForNumbers) {
  FeatureParameters parameters = atADecimetre().feature;
  parameters.decay = 1e-4;
  const auto contact =
      contactHypotheses(Pose::Identity(), lineAlong({1, 0, 0}, {0, 0.3, 0}), parameters, false);
  ASSERT_TRUE(contact);
  double sum = 0.0;
  for (int i = 0; i < contact->count; ++i) sum += std::exp(contact->log_prior[i]);
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(ContactHypotheses, AreNoneForNumbersThatAreNotFinite) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const LineOfAction sound = lineAlong({1, 0, 0}, {0, 0.1, 0});
  std::vector<LineOfAction> lines(6, sound);
  lines[0].point.y() = kNothing;
  lines[1].point.z() = kEndless;
  lines[2].direction.x() = kNothing;
  lines[3].pitch = kEndless;
  lines[4].direction_stddev = kNothing;
  lines[5].offset_stddev = kEndless;
  for (const bool planar : {true, false}) {
    for (const LineOfAction& line : lines) {
      EXPECT_FALSE(contactHypotheses(Pose::Identity(), line, {}, planar));
    }
    EXPECT_FALSE(contactHypotheses(makePose({0, kNothing, 0}), sound, {}, planar));
  }
}

TEST(ContactHypotheses, ALineOutOfReachSaysNothing) {
  EXPECT_FALSE(contactHypotheses(Pose::Identity(), lineAlong({1, 0, 0}, {0, 0.7, 0}),
                                 atADecimetre().feature, true));
}

}  // namespace
}  // namespace smore
