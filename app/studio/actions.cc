// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/actions.h"

#include <QMenuBar>

#include "app/studio/theme.h"

namespace loopscope {

Actions::Actions(QMainWindow* window, const RunLine& run) {
  for (const char* name : {"File", "Edit", "Step", "Selection", "View", "Window", "Help"}) {
    menus_[name] = window->menuBar()->addMenu(name);
  }
  for (const Command& command : Commands()) {
    if (command.menu.empty()) continue;
    auto* const action = new QAction(QString::fromStdString(command.title), window);
    QList<QKeySequence> keys;
    for (const std::string& key : command.keys) {
      keys.append(QKeySequence(QString::fromStdString(key), QKeySequence::PortableText));
    }
    action->setShortcuts(keys);
    const QString key = keys.isEmpty() ? QString() : keys.front().toString();
    action->setToolTip(action->text() + (key.isEmpty() ? "" : " (" + key + ")"));
    QObject::connect(action, &QAction::triggered, window,
                     [run, name = command.name] { run(name); });
    menus_.at(command.menu)->addAction(action);
    actions_[command.name] = action;
  }
  MakeIcons();
}

void Actions::AddToViewMenu(const QList<QAction*>& actions) {
  menus_.at("View")->addSeparator();
  menus_.at("View")->addActions(actions);
}

void Actions::Show(const Session& session) {
  for (const Command& command : Commands()) {
    const auto action = actions_.find(command.name);
    if (action != actions_.end()) action->second->setEnabled(command.is_possible(session));
  }
}

void Actions::MakeIcons() {
  for (const auto& [name, action] : actions_) action->setIcon(IconOf(name));
}

}  // namespace loopscope
