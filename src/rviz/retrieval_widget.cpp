// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_widget.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "panel_colors.h"
#include "smore/mapping/mask_bricks.h"

namespace smore {
namespace {

constexpr int kLookPeriod = 100;  // [ms]
constexpr int kHundred = 100;     // steps of the slider

// What the mapping tells once a second may be older than the slider's last move. Our choice.
constexpr int kOlderThanMove = 3000;  // [ms]

struct Level {
  const char* word;
  QColor color;
};

Level levelOf(int level) {
  using Diagnostic = diagnostic_msgs::DiagnosticStatus;
  switch (level) {
    case Diagnostic::OK:
      return {"OK", kRightColor};
    case Diagnostic::WARN:
      return {"WARN", kDoubtColor};
    case Diagnostic::ERROR:
      return {"ERROR", kWrongColor};
    default:
      return {"STALE", kSilentColor};
  }
}

QString inColor(const QString& text, const QColor& color) {
  return QString("<b><font color=\"%1\">%2</font></b>").arg(color.name(), text.toHtmlEscaped());
}

/// A number as it was told, with fewer digits.
QString rounded(const NodeStatus& status, const char* key, int digits) {
  bool is_number = false;
  const double value = QString::fromStdString(status.value(key, "")).toDouble(&is_number);
  return is_number ? QString::number(value, 'f', digits) : QString("?");
}

QLabel* makeLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

QLayout* makeSliderRow(QLabel* label, QSlider* slider) {
  auto* row = new QHBoxLayout;
  label->setWordWrap(false);
  row->addWidget(label);
  row->addWidget(slider);
  return row;
}

}  // namespace

RetrievalWidget::RetrievalWidget(RetrievalMonitor* monitor, RetrievalCommands* commands,
                                 QWidget* parent)
    : QWidget(parent), monitor_(monitor), commands_(commands), form_(new QFormLayout) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(phase_ = makeLabel("phase"));
  column->addWidget(outcome_ = makeLabel("outcome"));
  column->addWidget(progress_ = makeLabel("progress"));
  column->addWidget(bar_ = new ForceBar);
  column->addLayout(makeButtons());
  column->addLayout(makeFileRow());
  column->addLayout(makeShownRow());
  column->addLayout(makeWorldRow());
  column->addWidget(answer_ = makeLabel("answer"));
  column->addLayout(form_);
  guard_ = addLine("Guard", "guard");
  wrench_ = addLine("Wrench", "wrench");
  sensor_ = addLine("Sensor", "sensor");
  maps_ = addLine("Maps", "maps");
  plans_ = addLine("Plans", "plans");
  column->addStretch();
  QFont large = phase_->font();
  large.setBold(true);
  large.setPointSizeF(1.4 * large.pointSizeF());
  phase_->setFont(large);
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kLookPeriod);
  refresh();
}

QLabel* RetrievalWidget::addLine(const QString& title, const char* name) {
  QLabel* label = makeLabel(name);
  form_->addRow(title, label);
  return label;
}

QPushButton* RetrievalWidget::makeButton(const char* command, const std::function<void()>& act) {
  QString text = command;
  text[0] = text[0].toUpper();
  auto* button = new QPushButton(text);
  button->setObjectName(command);
  QObject::connect(button, &QPushButton::clicked, this, act);
  buttons_.emplace_back(button, command);
  return button;
}

QLayout* RetrievalWidget::makeButtons() {
  using Name = RetrievalCommands;
  auto* grid = new QGridLayout;
  QPushButton* stop = makeButton(Name::kStop, [this] { commands_->stop(); });
  stop->setText("STOP");
  stop->setStyleSheet(
      QString("background-color: %1; color: white; border: 1px solid black; border-radius: 3px; "
              "font-weight: bold; padding: 6px")
          .arg(kWrongColor.name()));
  constexpr int kColumns = 2;
  grid->addWidget(stop, 0, 0, 1, kColumns);
  retrieve_ = makeButton(Name::kRetrieve, [this] { commands_->retrieve(goal_); });
  QPushButton* plan = makeButton(Name::kPlan, [this] { commands_->plan(goal_); });
  plan->setToolTip("shows the way to the marked goal, and its risk; nothing moves");
  execute_ = makeButton(Name::kExecute, [this] { commands_->execute(goal_); });
  execute_->setToolTip("brings the object to the end of the way that is shown");
  clear_ = makeButton(Name::kClear, [this] { commands_->clearFault(); });
  const std::vector<QPushButton*> others = {
      plan,
      execute_,
      retrieve_,
      clear_,
      makeButton(Name::kTare, [this] { commands_->tare(); }),
      makeButton(Name::kIdentify, [this] { commands_->identifyPayload(); }),
      makeButton(Name::kReset, [this] { commands_->resetMaps(); }),
  };
  for (int i = 0; i < static_cast<int>(others.size()); ++i) {
    grid->addWidget(others[i], 1 + i / kColumns, i % kColumns);
  }
  return grid;
}

QLayout* RetrievalWidget::makeFileRow() {
  using Name = RetrievalCommands;
  auto* row = new QHBoxLayout;
  file_ = new QLineEdit("panel");
  file_->setObjectName("file");
  file_->setToolTip("name below the mapping's folder of beliefs");
  overwrite_ = new QCheckBox("over");
  overwrite_->setObjectName("overwrite");
  overwrite_->setToolTip("whether to save over a file that is there");
  const auto name = [this] { return file_->text().toStdString(); };
  row->addWidget(new QLabel("Belief"));
  row->addWidget(file_);
  row->addWidget(makeButton(
      Name::kSave, [this, name] { commands_->saveBelief(name(), overwrite_->isChecked()); }));
  row->addWidget(overwrite_);
  row->addWidget(makeButton(Name::kLoad, [this, name] { commands_->loadBelief(name()); }));
  return row;
}

QLayout* RetrievalWidget::makeShownRow() {
  shown_label_ = makeLabel("shown from");
  shown_ = new QSlider(Qt::Horizontal);
  shown_->setObjectName("shown");
  shown_->setRange(1, kHundred);
  QObject::connect(shown_, &QSlider::valueChanged, this, [this](int hundredths) {
    shown_moved_.start();
    commands_->showFrom(static_cast<double>(hundredths) / kHundred);
  });
  return makeSliderRow(shown_label_, shown_);
}

QLayout* RetrievalWidget::makeWorldRow() {
  world_label_ = makeLabel("sampled world");
  auto* world = new QSlider(Qt::Horizontal);
  world->setObjectName("world");
  world->setRange(0, kHypotheses);
  const auto say = [this](int number) {
    world_label_->setText(number == 0
                              ? QString("Sampled world: none")
                              : QString("Sampled world: %1 of %2").arg(number).arg(kHypotheses));
  };
  say(0);
  QObject::connect(world, &QSlider::valueChanged, this, [this, say](int number) {
    say(number);
    commands_->showWorld(number);
  });
  return makeSliderRow(world_label_, world);
}

// The slider may not leave the hand that moves it; else it stands where anybody has set it.
void RetrievalWidget::followShown(const RetrievalView& view) {
  const auto maps = view.statuses.find("mapping: maps");
  const bool is_moved = shown_->isSliderDown() ||
                        (shown_moved_.isValid() && !shown_moved_.hasExpired(kOlderThanMove));
  if (!is_moved && maps != view.statuses.end()) {
    const QSignalBlocker no_wish(shown_);
    const std::string told = maps->second.value("shown from probability", "0");
    shown_->setValue(
        static_cast<int>(std::lround(kHundred * QString::fromStdString(told).toDouble())));
  }
  const double probability = static_cast<double>(shown_->value()) / kHundred;
  shown_label_->setText(QString("Voxels from P = %1").arg(probability, 0, 'f', 2));
}

void RetrievalWidget::refresh() {
  const RetrievalView view = monitor_->view();
  goal_ = view.goal;
  phase_->setText(QString::fromStdString(view.phase));
  const QString ended = QString::fromStdString(view.outcome);
  outcome_->setText(ended.isEmpty() ? QString("no goal has ended yet")
                                    : "last goal: " +
                                          inColor(view.succeeded ? "reached" : "failed",
                                                  view.succeeded ? kRightColor : kWrongColor) +
                                          ", " + ended.toHtmlEscaped());
  progress_->setText(QString("contacts <b>%1</b> &nbsp; plans <b>%2</b> &nbsp; risk of the plan "
                             "<b>%3</b>")
                         .arg(view.contacts)
                         .arg(view.plans)
                         .arg(view.risk ? QString::number(*view.risk, 'f', 2) : QString("-")));
  answer_->setText(QString::fromStdString(commands_->answer()));
  answer_->setVisible(!answer_->text().isEmpty());
  showStatuses(view);
  showForce(view);
  followShown(view);
  enableButtons(view);
}

void RetrievalWidget::showStatuses(const RetrievalView& view) {
  showStatus(wrench_, view, "force_torque: wrench", [](const NodeStatus& status) {
    return rounded(status, "rate [Hz]", 0) + " Hz, dropped " +
           QString::fromStdString(status.value("dropped", "?"));
  });
  showStatus(sensor_, view, "force_torque: sensor", [](const NodeStatus& status) {
    return "payload " + rounded(status, "payload [kg]", 2) + " kg, saturated samples " +
           QString::fromStdString(status.value("saturated samples", "?"));
  });
  showStatus(maps_, view, "mapping: maps", [](const NodeStatus& status) {
    return "world " + rounded(status, "voxels of the world map", 0) + ", object " +
           rounded(status, "voxels of the object map", 0) + " voxels, " +
           rounded(status, "memory [MiB]", 0) + " MiB";
  });
  showStatus(plans_, view, "planner: plans", [](const NodeStatus& status) {
    return "plans " + QString::fromStdString(status.value("plans", "?")) + ", refused " +
           QString::fromStdString(status.value("plans refused", "?")) + ", longest " +
           rounded(status, "longest time of a plan [s]", 2) + " s";
  });
  showStatus(guard_, view, "guard: motion", [](const NodeStatus& status) {
    return "ceiling " + rounded(status, "ceiling of the force [N]", 0) + " N";
  });
  if (view.statuses.count("guard: motion") == 0) guard_->setText("none: the robot stops itself");
  if (!view.fault.empty()) {
    guard_->setText(inColor("FAULT", kWrongColor) + " " +
                    QString::fromStdString(view.fault).toHtmlEscaped());
  }
}

void RetrievalWidget::showForce(const RetrievalView& view) {
  const auto sensor = view.statuses.find("force_torque: sensor");
  const auto threshold = [&](const char* key) {
    if (sensor == view.statuses.end()) return 0.0;
    return QString::fromStdString(sensor->second.value(key, "0")).toDouble();
  };
  bar_->show(view.force, threshold("free force [N]"), threshold("contact force [N]"));
}

void RetrievalWidget::showStatus(QLabel* label, const RetrievalView& view, const std::string& name,
                                 const std::function<QString(const NodeStatus&)>& values) {
  const auto found = view.statuses.find(name);
  if (found == view.statuses.end()) {
    label->setText(inColor("STALE", kSilentColor) + " nothing is told of it");
    return;
  }
  const NodeStatus& status = found->second;
  const Level level = levelOf(status.level);
  label->setText(inColor(level.word, level.color) + " " +
                 QString::fromStdString(status.message).toHtmlEscaped() + "<br>" + values(status));
}

void RetrievalWidget::enableButtons(const RetrievalView& view) {
  for (const auto& [button, command] : buttons_) {
    button->setEnabled(command == RetrievalCommands::kStop || !commands_->running(command));
  }
  retrieve_->setText(view.reconstructs ? "Reconstruct" : "Retrieve");
  if (view.active) retrieve_->setEnabled(false);
  if (view.active || !view.wayLeadsToGoal()) execute_->setEnabled(false);
  if (view.fault.empty()) clear_->setEnabled(false);
}

}  // namespace smore
