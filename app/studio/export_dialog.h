// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace loopscope {

/// Asks for size and file of a picture, or of a film of it over some steps, and shows the command
/// line that makes it.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// Exports the picture of `request` of the recording of `session`.
  ExportDialog(const ViewRequest& request, const Session& session, QWidget* parent);

  /// What the program is to be run with. Throws as RenderArguments does.
  std::vector<std::string> arguments() const;
  QString path() const { return path_->text(); }

 private:
  QLayout* MakeSizeRow();
  QWidget* MakeStepsRow(const Session& session);
  QLayout* MakeFileRow();
  QWidget* MakeButtons();
  void ConnectRows();

  bool is_film() const { return what_->currentIndex() == 1; }
  ViewRequest RequestOfSize() const;
  QString DefaultPath() const;
  void ChoosePath();
  void ShowKind();
  void ShowCommandLine();

  ViewRequest request_;
  std::string run_;
  QComboBox* what_ = nullptr;
  QSpinBox* width_ = nullptr;
  QSpinBox* height_ = nullptr;
  QWidget* steps_ = nullptr;
  QSpinBox* first_ = nullptr;
  QSpinBox* last_ = nullptr;
  QSpinBox* stride_ = nullptr;
  QSpinBox* frames_per_second_ = nullptr;
  QLineEdit* path_ = nullptr;
  QPlainTextEdit* command_line_ = nullptr;
};

}  // namespace loopscope
