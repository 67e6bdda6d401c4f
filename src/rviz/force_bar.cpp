// SPDX-License-Identifier: BSD-3-Clause
#include "force_bar.h"

#include <QPainter>
#include <algorithm>

#include "panel_colors.h"

namespace smore {
namespace {

constexpr double kDefaultEnd = 10.0;  // of the bar where no threshold is known [N]

}  // namespace

ForceBar::ForceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ForceBar::show(const std::optional<double>& force, double free_force, double contact_force) {
  force_ = force;
  free_force_ = free_force;
  contact_force_ = contact_force;
  update();
}

QSize ForceBar::sizeHint() const {
  constexpr int kWidth = 200;
  return {kWidth, 2 * fontMetrics().height() + 2};
}

int ForceBar::place(double force) const {
  const double end = contact_force_ > 0.0 ? 2.0 * contact_force_ : kDefaultEnd;
  return static_cast<int>(std::min(1.0, force / end) * (width() - 1));
}

void ForceBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const int line = fontMetrics().height();
  painter.fillRect(0, 0, width(), line, palette().base());
  if (force_) {
    const bool touches = contact_force_ > 0.0 && *force_ >= contact_force_;
    const bool free = *force_ < free_force_;
    painter.fillRect(0, 0, place(*force_), line,
                     touches ? kWrongColor : (free ? kRightColor : kDoubtColor));
  }
  painter.drawRect(0, 0, width() - 1, line);
  painter.drawText(QRect(0, 0, width() - 4, line), Qt::AlignRight | Qt::AlignVCenter,
                   force_ ? QString::number(*force_, 'f', 1) + " N" : QString("no force"));
  if (contact_force_ <= 0.0) return;
  const auto mark = [&](double force, const QString& name, Qt::Alignment side) {
    const int x = place(force);
    painter.drawLine(x, 0, x, line + 2);
    const QRect left(0, line + 2, x + fontMetrics().horizontalAdvance(name) / 2, line);
    painter.drawText(side == Qt::AlignLeft ? QRect(0, line + 2, width(), line) : left, side, name);
  };
  mark(free_force_, QString("free < %1 N").arg(free_force_), Qt::AlignLeft);
  mark(contact_force_, QString("contact %1 N").arg(contact_force_), Qt::AlignRight);
}

}  // namespace smore
