// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "force_bar.h"
#include "retrieval_commands.h"
#include "retrieval_monitor.h"

namespace smore {

/// Shows how a retrieval goes and what its nodes say of themselves, and has a button for each thing
/// that they can be told. It waits for nobody: it looks ten times a second at what is known. Its
/// buttons have the names of their commands, its labels those of what they show, for who looks for
/// them with findChild.
class RetrievalWidget : public QWidget {
 public:
  /// Both must outlive it.
  RetrievalWidget(RetrievalMonitor* monitor, RetrievalCommands* commands,
                  QWidget* parent = nullptr);

 private:
  QLabel* addLine(const QString& title, const char* name);
  QPushButton* makeButton(const char* command, const std::function<void()>& act);
  QLayout* makeButtons();
  QLayout* makeFileRow();
  QLayout* makeShownRow();
  QLayout* makeWorldRow();
  void followShown(const RetrievalView& view);
  void refresh();
  void showStatuses(const RetrievalView& view);
  void showForce(const RetrievalView& view);
  void showStatus(QLabel* label, const RetrievalView& view, const std::string& name,
                  const std::function<QString(const NodeStatus&)>& values);
  void enableButtons(const RetrievalView& view);

  RetrievalMonitor* monitor_;
  RetrievalCommands* commands_;
  QFormLayout* form_;
  QLabel *phase_, *outcome_, *progress_;
  ForceBar* bar_;
  QLabel *guard_, *wrench_, *sensor_, *maps_, *plans_, *answer_;
  QPushButton *retrieve_ = nullptr, *execute_ = nullptr, *clear_ = nullptr;
  QLineEdit* file_ = nullptr;
  QCheckBox* overwrite_ = nullptr;
  std::vector<std::pair<QPushButton*, std::string>> buttons_;  ///< and their commands
  QSlider* shown_ = nullptr;  ///< least probability of the voxels shown, in hundredths
  QLabel *shown_label_ = nullptr, *world_label_ = nullptr;
  QElapsedTimer shown_moved_;  ///< since it was moved last
  QTimer timer_;
  RetrievalCommands::Goal goal_;  ///< that is marked
};

}  // namespace smore
