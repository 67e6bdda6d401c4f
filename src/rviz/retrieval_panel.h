// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include "retrieval_commands.h"
#include "retrieval_monitor.h"

namespace smore {

/// The retrieval widget as a panel of rviz, for the nodes of the namespace that rviz runs in.
class RetrievalPanel : public rviz::Panel {
 public:
  explicit RetrievalPanel(QWidget* parent = nullptr);

 private:
  RetrievalMonitor monitor_;
  RetrievalCommands commands_;
};

}  // namespace smore
