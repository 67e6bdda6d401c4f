// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_panel.h"

#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "retrieval_widget.h"

namespace smore {

RetrievalPanel::RetrievalPanel(QWidget* parent)
    : rviz::Panel(parent), monitor_(ros::NodeHandle()), commands_(ros::NodeHandle()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(new RetrievalWidget(&monitor_, &commands_));
}

}  // namespace smore

PLUGINLIB_EXPORT_CLASS(smore::RetrievalPanel, rviz::Panel)
