// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <map>
#include <string>

#include "app/session/commands.h"
#include "app/studio/run_line.h"

namespace loopscope {

/// The commands that need no argument as actions of a window, for its menus, keys and tool bar.
class Actions {
 public:
  /// Fills the menu bar of `window`.
  Actions(QMainWindow* window, const RunLine& run);

  QAction* of(const std::string& command) const { return actions_.at(command); }

  /// Adds what is no command: the docks, and the recent files.
  void AddToViewMenu(const QList<QAction*>& actions);
  void AddToFileMenu(QMenu* menu) { menus_.at("File")->insertMenu(actions_.at("file.demo"), menu); }

  /// Which of them are possible now.
  void Show(const Session& session);
  /// Icons in the colours of the window.
  void MakeIcons();

 private:
  std::map<std::string, QMenu*> menus_;
  std::map<std::string, QAction*> actions_;
};

}  // namespace loopscope
