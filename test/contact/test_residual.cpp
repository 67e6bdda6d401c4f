// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "data_sheet_noise.h"
#include "sensor_feed.h"
#include "smore/contact/contact_sensing.h"

namespace smore {
namespace {

SensorNoise quiet() { return {}; }

/// A hand that moves along x at 0.05 m/s, with a gripper that keeps `kept` once it has touched.
class ResidualTest : public ::testing::TestWithParam<SensorNoise> {
 protected:
  using Contact = std::function<Wrench(double x)>;

  ResidualTest() : feed_(GetParam(), 0.002, {0.5, 0.02, 0.02, 0.02, 0.02}, 211) {
    ContactSensingParameters parameters;
    parameters.noise = GetParam();
    sensing_.emplace(parameters);
    stand(8.0);
    EXPECT_TRUE(sensing_->tared());
  }

  static Wrench nothing(double /*x*/) { return {}; }

  void step(double speed, const Contact& contact) {
    x_ += 0.002 * speed;
    Wrench felt = contact(x_);
    felt.force += kept_;
    for (WrenchSample sample : feed_.next(felt)) {
      sample.T_world_object.translation().x() = x_;
      const auto observation = sensing_->process(sample);
      if (!observation) continue;
      last_ = *observation;
      if (observation->line) line_ = observation->line;
      if (observation->state == ContactState::kFree) ++free_;
      if (sensing_->newResidual()) residual_ = sensing_->newResidual();
    }
  }

  void moveTo(double x, const Contact& contact = nothing) {
    const double speed = x > x_ ? 0.05 : -0.05;
    while ((x - x_) * speed > 0.0) step(speed, contact);
    x_ = x;
  }

  void stand(double duration, const Contact& contact = nothing) {
    free_ = 0;
    for (const double end = feed_.time() + duration; feed_.time() < end;) step(0.0, contact);
  }

  /// Comes from free space, touches with 12 N and stands until the line is given.
  void touch() {
    moveTo(0.05);
    stand(0.5, hard_);
    EXPECT_EQ(last_.state, ContactState::kContact);
    EXPECT_TRUE(line_);
  }

  const Contact hard_ = [](double) { return Wrench{Vec3(-12, 0, 0), Vec3::Zero()}; };
  SensorFeed feed_;
  std::optional<ContactSensing> sensing_;
  double x_ = 0.0;
  Vec3 kept_ = Vec3::Zero();
  ContactObservation last_;
  std::optional<LineOfAction> line_;
  std::optional<Wrench> residual_;
  int free_ = 0;
};

TEST_P(ResidualTest, whatIsFeltWhereNothingTouchedBeforeBecomesBias) {
  touch();
  kept_ = Vec3(-2.0, 1.5, 1.0);  // 2.7 N: more than the release force
  moveTo(0.0);
  stand(1.9);  // a robot waits for 2 s
  ASSERT_TRUE(residual_);
  EXPECT_LT((residual_->force - kept_).norm(), 0.6);
  EXPECT_EQ(last_.contact_id, 1);
  EXPECT_GT(free_, 10);
  stand(2.0);
  EXPECT_GT(free_, 900) << "of a thousand samples or so";

  line_.reset();
  moveTo(0.05);
  stand(0.5, hard_);
  EXPECT_EQ(last_.contact_id, 2);
  ASSERT_TRUE(line_);
  EXPECT_LT(line_->direction.cross(Vec3(-1, 0, 0)).norm(), 4.0 * line_->direction_stddev + 1e-3);
}

TEST_P(ResidualTest, itMayBeFeltWithoutAnyWay) {
  stand(2.0);
  stand(0.5, hard_);
  kept_ = Vec3(0, 2.9, 0);
  stand(2.0);
  EXPECT_TRUE(residual_);
  EXPECT_GT(free_, 10);
}

TEST_P(ResidualTest, aLightTouchThatGoesOnIsNoResidual) {
  touch();
  // Half a millimetre back from 12 N: 2.5 N are left of it.
  moveTo(0.0495, hard_);
  stand(20.0, [](double) { return Wrench{Vec3(-2.5, 0, 0), Vec3::Zero()}; });
  EXPECT_FALSE(residual_);
}

TEST_P(ResidualTest, aSlideBackTheWayItCameIsNoResidual) {
  const Contact slide = [](double) { return Wrench{Vec3(0, -2.7, 0), Vec3::Zero()}; };
  moveTo(0.02);
  stand(1.0, slide);
  moveTo(0.2, slide);
  stand(0.5, hard_);
  moveTo(0.1, slide);
  stand(20.0, slide);
  EXPECT_FALSE(residual_);
}

TEST_P(ResidualTest, whatIsMoreThanAGripperKeepsIsNone) {
  touch();
  kept_ = Vec3(0, 7.0, 0);
  moveTo(0.0);
  stand(10.0);
  EXPECT_FALSE(residual_);
  EXPECT_EQ(free_, 0);
}

TEST_P(ResidualTest, aTareIsRefusedWhileSomethingPresses) {
  EXPECT_EQ(sensing_->tareObjection(), "");
  touch();
  EXPECT_NE(sensing_->tareObjection().find("presses with 1"), std::string::npos)
      << sensing_->tareObjection();
  kept_ = Vec3(0, 2.0, 0);
  moveTo(0.0);
  stand(0.6);
  EXPECT_EQ(sensing_->tareObjection(), "") << "it cannot be told from a light touch yet";
}

TEST_P(ResidualTest, aTareIsNotRefusedAfterTheDriverHasZeroedTheSensor) {
  kept_ = Vec3(-3.0, 20.0, -10.0);  // takes the sensor's own bias off
  stand(0.5);
  EXPECT_EQ(last_.state, ContactState::kContact);
  EXPECT_EQ(sensing_->tareObjection(), "");
}

INSTANTIATE_TEST_SUITE_P(Sensors, ResidualTest, ::testing::Values(quiet(), dataSheet()),
                         [](const auto& instance) {
                           return instance.param.force_stddev > 0.0 ? "DataSheet" : "Quiet";
                         });

}  // namespace
}  // namespace smore
