// SPDX-License-Identifier: BSD-3-Clause
// A person who drags the goal, as rviz tells the nodes of it, and then clicks in the panel.
#include <gtest/gtest.h>
#include <ros/topic.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/InteractiveMarkerUpdate.h>

#include <mutex>

#include "smore/ros/conversions.h"
#include "smore/ros/goal_marker_message.h"
#include "tested_panel.h"

namespace smore {
namespace {

using Feedback = visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::InteractiveMarker;

/// What rviz does with an interactive marker: shows what comes, and tells of the mouse.
class MarkerInHand {
 public:
  MarkerInHand() {
    told_ = node_.advertise<Feedback>("/smore/goal_marker/feedback", kQueue);
    updates_ = node_.subscribe("/smore/goal_marker/update", kQueue, &MarkerInHand::onUpdate, this);
    init_ = node_.subscribe("/smore/goal_marker/update_full", 1, &MarkerInHand::onInit, this);
  }

  bool isThere() const {
    return QTest::qWaitFor([&] { return told_.getNumSubscribers() > 0 && !text().empty(); },
                           kDeadline);
  }

  void tell(int event, double x, double y, int menu_entry = 0) const {
    Feedback feedback;
    feedback.header.frame_id = "world";
    feedback.client_id = "test";
    feedback.marker_name = kGoalMarkerName;
    feedback.event_type = static_cast<std::uint8_t>(event);
    feedback.menu_entry_id = menu_entry;
    feedback.pose = toMessage(makePose({x, y, 0.0}));
    told_.publish(feedback);
  }

  /// Whether the marker comes to stand at x and y and to say the words.
  bool shows(double x, double y, const std::string& words) const {
    const auto is_shown = [&] {
      const InteractiveMarker now = marker();
      return std::abs(now.pose.position.x - x) < kSame &&
             std::abs(now.pose.position.y - y) < kSame && text().find(words) != std::string::npos;
    };
    return QTest::qWaitFor(is_shown, kDeadline);
  }

  std::string text() const {
    for (const auto& control : marker().controls) {
      if (control.name == "text") return control.markers.at(0).text;
    }
    return "";
  }

 private:
  static constexpr std::uint32_t kQueue = 100;
  static constexpr double kSame = 1e-6;  // [m]

  InteractiveMarker marker() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return marker_;
  }
  void onUpdate(const visualization_msgs::InteractiveMarkerUpdate& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!message.markers.empty()) marker_ = message.markers.back();
  }
  void onInit(const visualization_msgs::InteractiveMarkerInit& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!message.markers.empty()) marker_ = message.markers.back();
  }

  ros::NodeHandle node_;
  ros::Publisher told_;
  ros::Subscriber updates_, init_;
  mutable std::mutex mutex_;  ///< guards the marker
  InteractiveMarker marker_;
};

class DraggedGoal : public Panel {
 protected:
  void SetUp() override {
    Panel::SetUp();
    ASSERT_TRUE(marker_.isThere());
  }

  void TearDown() override {
    marker_.tell(Feedback::MENU_SELECT, 0.0, 0.0, kBackToTheTasksGoal);
    EXPECT_TRUE(marker_.shows(-0.3, 0.0, "the way"));
  }

  const MarkerInHand marker_;
};

TEST_F(DraggedGoal, IsGoneToOnceTheWayThereWasShown) {
  marker_.tell(Feedback::MOUSE_DOWN, -0.3, 0.0);
  for (const double x : {-0.2, -0.1, 0.0, 0.1}) {
    marker_.tell(Feedback::POSE_UPDATE, x, -0.1);
    ASSERT_TRUE(marker_.shows(x, -0.1, "touches here with probability")) << marker_.text();
  }
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !panel_.button(RetrievalCommands::kExecute)->isEnabled(); }, kDeadline))
      << "no way there has been shown";
  marker_.tell(Feedback::MOUSE_UP, 0.1, -0.1);
  EXPECT_TRUE(marker_.shows(0.1, -0.1, "the way touches with probability")) << marker_.text();
  ASSERT_TRUE(panel_.click(RetrievalCommands::kExecute));
  ASSERT_TRUE(panel_.shows("answer", "execute: begun"));
  ASSERT_TRUE(panel_.shows("phase", "moving along the way"));
  ASSERT_TRUE(panel_.shows("outcome", "reached")) << panel_.text("outcome").toStdString();
  const auto now = ros::topic::waitForMessage<smore_msgs::ContactObservation>("/smore/contact",
                                                                              ros::Duration(10));
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->pose.position.x, 0.1, 0.03);
  EXPECT_NEAR(now->pose.position.y, -0.1, 0.03);
}

TEST_F(DraggedGoal, SaysWhereTheObjectMayNotGo) {
  marker_.tell(Feedback::MOUSE_DOWN, -0.3, 0.0);
  marker_.tell(Feedback::POSE_UPDATE, 0.4, 0.0);
  EXPECT_TRUE(marker_.shows(0.4, 0.0, "not allowed: ")) << marker_.text();
  marker_.tell(Feedback::MOUSE_UP, 0.4, 0.0);
  EXPECT_TRUE(marker_.shows(0.4, 0.0, "no way: ")) << marker_.text();
  EXPECT_FALSE(panel_.button(RetrievalCommands::kExecute)->isEnabled());
}

TEST_F(DraggedGoal, IsWherePlanOnlyLeads) {
  marker_.tell(Feedback::POSE_UPDATE, -0.1, -0.2);
  ASSERT_TRUE(marker_.shows(-0.1, -0.2, "touches here"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !panel_.button(RetrievalCommands::kExecute)->isEnabled(); }, kDeadline));
  ASSERT_TRUE(panel_.click(RetrievalCommands::kPlan));
  EXPECT_TRUE(panel_.shows("answer", "plan only: touches with probability"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return panel_.button(RetrievalCommands::kExecute)->isEnabled(); }, kDeadline));
}

}  // namespace
}  // namespace smore
