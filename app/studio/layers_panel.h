// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeWidget>
#include <optional>

#include "app/session/session.h"
#include "app/studio/run_line.h"

namespace loopscope {

/// The layers of the active view, from the top to the bottom, each to be switched on and off.
class LayersPanel : public QTreeWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(RunLine run, QWidget* parent = nullptr);

  void Show(const Session& session);

 private:
  void List(ViewKind view);

  RunLine run_;
  std::optional<ViewKind> view_;
  bool is_showing_ = false;
};

}  // namespace loopscope
