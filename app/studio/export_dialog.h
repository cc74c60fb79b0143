// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>

#include "render/view.h"

namespace loopscope {

/// Asks for size and file of a picture, and shows the command line that draws it.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// The picture of `request` of the recording in the file `run`.
  ExportDialog(const ViewRequest& request, std::string run, QWidget* parent);

  /// With the size that was chosen.
  ViewRequest request() const;
  QString path() const { return path_->text(); }

 private:
  QString DefaultPath() const;
  void ChoosePath();
  void ShowCommandLine();

  ViewRequest request_;
  std::string run_;
  QSpinBox* width_;
  QSpinBox* height_;
  QLineEdit* path_;
  QPlainTextEdit* command_line_;
};

}  // namespace loopscope
