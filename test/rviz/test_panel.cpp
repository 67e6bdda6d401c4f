// SPDX-License-Identifier: BSD-3-Clause
// A person who has nothing but the panel: clicks on its buttons, with the nodes running.
#include <gtest/gtest.h>
#include <octomap_msgs/Octomap.h>
#include <ros/topic.h>
#include <std_msgs/Float64.h>
#include <visualization_msgs/MarkerArray.h>

#include <QRegularExpression>
#include <atomic>
#include <future>
#include <mutex>

#include "smore/ros/names.h"
#include "tested_panel.h"

namespace smore {
namespace {

TEST_F(Panel, BringsTheObjectToTheGoal) {
  ASSERT_TRUE(panel_.click(RetrievalCommands::kRetrieve));
  ASSERT_TRUE(panel_.shows("phase", "moving along the way"));
  EXPECT_FALSE(panel_.button(RetrievalCommands::kRetrieve)->isEnabled()) << "it has a goal";
  EXPECT_FALSE(panel_.text("progress").contains("<b>-"));
  ASSERT_TRUE(panel_.shows("outcome", "reached")) << panel_.text("outcome").toStdString();
  EXPECT_TRUE(panel_.shows("progress", "risk of the plan <b>-")) << "it has no goal";
  const QRegularExpression contacts("contacts <b>[1-9]");
  EXPECT_TRUE(contacts.match(panel_.text("progress")).hasMatch())
      << panel_.text("progress").toStdString();
  const auto now = ros::topic::waitForMessage<smore_msgs::ContactObservation>("/smore/contact",
                                                                              ros::Duration(10));
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->pose.position.x, -0.3, 0.03);
}

TEST_F(Panel, ShowsTheSampledWorldOfTheSlider) {
  std::mutex mutex;
  std::string label;
  ros::NodeHandle node;
  const boost::function<void(const visualization_msgs::MarkerArray::ConstPtr&)> look =
      [&](const auto& message) {
        const std::lock_guard<std::mutex> lock(mutex);
        label = message->markers.back().text;
      };
  const ros::Subscriber worlds = node.subscribe("/smore/sampled_world", 1, look);
  const auto says = [&](const std::string& words) {
    return QTest::qWaitFor(
        [&] {
          const std::lock_guard<std::mutex> lock(mutex);
          return label.rfind(words, 0) == 0;
        },
        kDeadline);
  };
  ASSERT_TRUE(panel_.click(RetrievalCommands::kRetrieve));
  ASSERT_TRUE(panel_.shows("progress", "contacts <b>1"));
  for (const int number : {3, 64}) {
    panel_.child<QSlider>("world")->setValue(number);
    EXPECT_TRUE(panel_.shows("sampled world", QString("%1 of 64").arg(number)));
    EXPECT_TRUE(says("world " + std::to_string(number) + " of 64")) << label;
  }
  panel_.child<QSlider>("world")->setValue(0);
  EXPECT_TRUE(panel_.shows("sampled world", "none"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const std::lock_guard<std::mutex> lock(mutex);
        return label.empty();
      },
      kDeadline));
  ASSERT_TRUE(panel_.click(RetrievalCommands::kStop));
  EXPECT_TRUE(panel_.shows("phase", "waiting for a goal"));
}

TEST_F(Panel, StopsARetrievalThatHasJustBegunAndOneThatMoves) {
  const auto stop = [&] {
    QTest::mouseClick(panel_.button(RetrievalCommands::kStop), Qt::LeftButton);
    EXPECT_TRUE(panel_.shows("phase", "waiting for a goal"));
    EXPECT_TRUE(panel_.shows("outcome", "stopped by the user"))
        << panel_.text("outcome").toStdString();
    EXPECT_TRUE(panel_.shows("answer", "stop: the robot was told to stop"));
  };
  ASSERT_TRUE(panel_.click(RetrievalCommands::kRetrieve));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return panel_.text("phase") != "waiting for a goal"; }, kDeadline));
  stop();
  ASSERT_TRUE(panel_.click(RetrievalCommands::kRetrieve));
  ASSERT_TRUE(panel_.shows("phase", "moving along the way"));
  stop();
}

TEST_F(Panel, ShowsHowTheNodesFare) {
  ros::NodeHandle node;
  const boost::function<void(const octomap_msgs::Octomap::ConstPtr&)> look = [](const auto&) {};
  const ros::Subscriber looks[] = {node.subscribe("/smore/world/octomap_binary", 1, look),
                                   node.subscribe("/smore/object/octomap_binary", 1, look)};
  EXPECT_TRUE(panel_.shows("wrench", "500 Hz"));
  EXPECT_TRUE(panel_.shows("sensor", "the bias known to 0.00 N"));
  EXPECT_TRUE(panel_.shows("maps", "world 0, object 0 voxels"));
  EXPECT_TRUE(panel_.shows("plans", "OK"));
  EXPECT_TRUE(panel_.shows("guard", "none"));
}

/// Whether the mapping comes to show voxels from this probability on.
bool isShownFrom(double probability) {
  return QTest::qWaitFor(
      [&] {
        double now = 0.0;
        ros::param::get("/smore/mapping/display_min_probability", now);
        return now == probability;
      },
      kDeadline);
}

/// As by dynamic_reconfigure, or another panel.
void wishFromElsewhere(double probability) {
  ros::NodeHandle node;
  const ros::Publisher wish = node.advertise<std_msgs::Float64>("/smore/shown_probability", 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return wish.getNumSubscribers() > 0; }, kDeadline));
  std_msgs::Float64 message;
  message.data = probability;
  wish.publish(message);
  EXPECT_TRUE(isShownFrom(probability));
}

TEST_F(Panel, ShowsVoxelsFromTheProbabilityOfTheSliderOn) {
  EXPECT_TRUE(panel_.shows("shown from", "P = 0.30")) << "the mapping's own";
  panel_.child<QSlider>("shown")->setValue(60);
  EXPECT_TRUE(panel_.shows("shown from", "P = 0.60"));
  const auto told =
      ros::topic::waitForMessage<std_msgs::Float64>("/smore/shown_probability", ros::Duration(10));
  ASSERT_TRUE(told);
  EXPECT_DOUBLE_EQ(told->data, 0.6);
  EXPECT_TRUE(isShownFrom(0.6));
  wishFromElsewhere(0.4);
  EXPECT_TRUE(panel_.shows("shown from", "P = 0.40")) << "it follows again";
  panel_.child<QSlider>("shown")->setValue(30);
  EXPECT_TRUE(isShownFrom(0.3));
}

TEST_F(Panel, PlansWithoutAMotion) {
  ASSERT_TRUE(panel_.click(RetrievalCommands::kPlan));
  EXPECT_TRUE(panel_.shows("answer", "plan only: touches with probability"))
      << panel_.text("answer").toStdString();
  EXPECT_TRUE(panel_.shows("plans", "the last plan took"));
  EXPECT_EQ(panel_.text("phase"), "waiting for a goal");
}

TEST_F(Panel, TaresAndSavesAndLoadsWhatTheMapsAreMadeOf) {
  ASSERT_TRUE(panel_.click(RetrievalCommands::kTare));
  EXPECT_TRUE(panel_.shows("answer", "tare: tared"));
  panel_.child<QLineEdit>("file")->setText("panel_test");
  panel_.child<QCheckBox>("overwrite")->setChecked(true);
  ASSERT_TRUE(panel_.click(RetrievalCommands::kSave));
  EXPECT_TRUE(panel_.shows("answer", "panel_test.evidence")) << panel_.text("answer").toStdString();
  ASSERT_TRUE(panel_.click(RetrievalCommands::kLoad));
  EXPECT_TRUE(panel_.shows("answer", "load: ")) << panel_.text("answer").toStdString();
}

TEST(PanelAlone, StopNeverWaitsForAnotherCall) {
  ros::NodeHandle node("fake");
  std::promise<void> release;
  std::atomic<bool> tares{false}, stopped{false};
  using Trigger = std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> tare =
      [&, released = release.get_future().share()](auto& /*request*/, auto& /*response*/) {
        tares = true;
        released.wait();
        return true;
      };
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> stop = [&](auto& /*request*/,
                                                                                auto& response) {
    response.message = "stopped";
    return stopped = true;
  };
  const ros::ServiceServer servers[] = {node.advertiseService(names::kListenerTare, tare),
                                        node.advertiseService(names::kStop, stop)};
  const TestedPanel panel("fake");
  ASSERT_TRUE(panel.click(RetrievalCommands::kTare));
  ASSERT_TRUE(QTest::qWaitFor([&] { return tares.load(); }, kDeadline));
  ASSERT_TRUE(panel.click(RetrievalCommands::kStop));
  EXPECT_TRUE(QTest::qWaitFor([&] { return stopped.load(); }, kDeadline));
  EXPECT_TRUE(panel.shows("answer", "stop: stopped"));
  EXPECT_FALSE(panel.button(RetrievalCommands::kTare)->isEnabled()) << "it runs still";
  release.set_value();
  EXPECT_TRUE(panel.shows("answer", "tare"));
}

TEST(PanelAlone, AsksTheGuardToStopWhereTheRetrievalDoesNotAnswer) {
  ros::NodeHandle node("fake");
  std::promise<void> release;
  using Trigger = std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> hangs =
      [released = release.get_future().share()](auto& /*request*/, auto& /*response*/) {
        released.wait();
        return true;
      };
  std::atomic<bool> stopped{false};
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> stop =
      [&](auto& /*request*/, auto& /*response*/) { return stopped = true; };
  const ros::ServiceServer servers[] = {node.advertiseService(names::kStop, hangs),
                                        node.advertiseService(names::kGuardStop, stop)};
  const TestedPanel panel("fake");
  ASSERT_TRUE(panel.click(RetrievalCommands::kStop));
  EXPECT_TRUE(panel.shows("answer", "stop: the retrieval does not answer: by the guard"));
  EXPECT_TRUE(stopped);
  release.set_value();
}

TEST(PanelAlone, SaysWhoIsNotThere) {
  const TestedPanel panel("nobody");
  EXPECT_TRUE(panel.shows("phase", "no retrieval node"));
  EXPECT_TRUE(panel.shows("maps", "STALE"));
  ASSERT_TRUE(panel.click(RetrievalCommands::kStop));
  EXPECT_TRUE(panel.shows("answer", "nobody answers"));
  ASSERT_TRUE(panel.click(RetrievalCommands::kRetrieve));
  EXPECT_TRUE(panel.shows("answer", "nobody takes goals"));
  ASSERT_TRUE(panel.click(RetrievalCommands::kTare));
  EXPECT_TRUE(panel.shows("answer", "does not answer; is its node up?"));
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_test");
  const ros::NodeHandle keeps_ros_running;
  ros::AsyncSpinner spinner(4);  // for the services of the tests, of which some wait
  spinner.start();
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
