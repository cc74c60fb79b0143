// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include "core/slam/options.h"

namespace loopscope {

/// All options with unit, default and one sentence each; those that differ from the default are
/// marked. The person may edit them, or read them from a file.
class OptionsDialog : public QDialog {
  Q_OBJECT

 public:
  OptionsDialog(const Options& options, QWidget* parent);

  const Options& options() const { return options_; }

 private:
  void Fill();
  void Filter(const QString& text);
  void Edit(QTreeWidgetItem* item);
  void ReadFromFile();

  Options options_;
  QLineEdit* search_;
  QTreeWidget* tree_;
  QLabel* message_;
  bool is_filling_ = false;
};

}  // namespace loopscope
