// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <string>

#include "app/studio/run_line.h"

namespace loopscope {

/// The files that were opened last, as a menu; they are remembered beyond the window.
class RecentFiles : public QMenu {
 public:
  explicit RecentFiles(RunLine run, QWidget* parent = nullptr);

  /// Puts a file first.
  void Add(const std::string& path);
  /// Of the file that was opened last; empty if there is none.
  static QString Folder();

 private:
  void Fill();

  RunLine run_;
};

}  // namespace loopscope
