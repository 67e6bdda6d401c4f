// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <QApplication>
#include <QtTest>
#include <string>

#include "../../src/rviz/retrieval_widget.h"

namespace smore {

constexpr int kDeadline = 40000;  // [ms]; only failing tests wait so long

/// The panel of the nodes in one namespace.
class TestedPanel {
 public:
  explicit TestedPanel(const std::string& space)
      : monitor_(ros::NodeHandle(space)),
        commands_(ros::NodeHandle(space)),
        widget_(&monitor_, &commands_) {
    widget_.show();
  }

  QString text(const char* label) const { return widget_.findChild<QLabel*>(label)->text(); }

  bool shows(const char* label, const QString& words) const {
    return QTest::qWaitFor([&] { return text(label).contains(words); }, kDeadline);
  }

  QPushButton* button(const char* name) const { return widget_.findChild<QPushButton*>(name); }

  bool click(const char* name) const {
    if (!QTest::qWaitFor([&] { return button(name)->isEnabled(); }, kDeadline)) return false;
    QTest::mouseClick(button(name), Qt::LeftButton);
    return true;
  }

  template <typename Child>
  Child* child(const char* name) const {
    return widget_.findChild<Child*>(name);
  }

 private:
  RetrievalMonitor monitor_;
  RetrievalCommands commands_;
  RetrievalWidget widget_;
};

/// The object at the start of a simulation, and maps of nothing.
class Panel : public testing::Test {
 protected:
  void SetUp() override {
    const ros::NodeHandle node("smore");
    std_srvs::Trigger call;
    ASSERT_TRUE(ros::service::waitForService("/smore/simulator/reset", kDeadline));
    ASSERT_TRUE(ros::service::call("/smore/simulator/reset", call));
    ASSERT_TRUE(panel_.shows("phase", "waiting for a goal"));
    ASSERT_TRUE(panel_.shows("sensor", "tared"));
    ASSERT_TRUE(panel_.click(RetrievalCommands::kReset));
    ASSERT_TRUE(panel_.shows("answer", "all observations are forgotten"));
  }

  TestedPanel panel_{"smore"};
};

}  // namespace smore
