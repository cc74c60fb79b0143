// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <vector>

namespace loopscope {

/// The docks around the views of a window. They can be moved, torn off and closed.
class Docks {
 public:
  explicit Docks(QMainWindow* window) : window_(window) {}

  /// `title` is the name of its place in a layout that is kept, too.
  QDockWidget* Add(const char* title, QWidget* content, Qt::DockWidgetArea area);

  /// Puts all where they are on the first day: those of an area behind each other, the first of
  /// them in front.
  void Arrange();

  const std::vector<QDockWidget*>& all() const { return docks_; }

 private:
  QMainWindow* window_;
  std::vector<QDockWidget*> docks_;
  std::vector<Qt::DockWidgetArea> areas_;  // of docks_, on the first day
};

}  // namespace loopscope
