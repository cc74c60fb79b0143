// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

#include "app/session/session.h"
#include "app/studio/run_line.h"

namespace loopscope {

/// Finds commands by what is typed, and runs one: "step.seek 120" as well as "next loop".
class PaletteDialog : public QDialog {
  Q_OBJECT

 public:
  PaletteDialog(const Session& session, RunLine run, QWidget* parent);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void Fill();
  void RunChosen();

  const Session& session_;
  RunLine run_;
  QLineEdit* text_;
  QListWidget* list_;
};

/// All keys, by menu.
class KeysDialog : public QDialog {
  Q_OBJECT

 public:
  explicit KeysDialog(QWidget* parent);
};

}  // namespace loopscope
