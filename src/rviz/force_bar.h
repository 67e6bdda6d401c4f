// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <optional>

namespace smore {

/// What is felt, as a bar between nothing and twice the contact force, with marks at the forces
/// below which it is free space and from which on it is contact.
class ForceBar : public QWidget {
 public:
  explicit ForceBar(QWidget* parent = nullptr);

  /// `force` [N]: nothing where none is known. Without thresholds, both 0, there are no marks.
  void show(const std::optional<double>& force, double free_force, double contact_force);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int place(double force) const;

  std::optional<double> force_;                    ///< [N]
  double free_force_ = 0.0, contact_force_ = 0.0;  ///< [N]
};

}  // namespace smore
