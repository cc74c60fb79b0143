// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "app/mapping.h"
#include "app/session/session.h"
#include "app/studio/run_line.h"

class QDoubleSpinBox;
class QComboBox;

namespace loopscope {

/// One message above the views, until it is closed or another comes.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void Tell(const QString& text);
  QString text() const { return text_->text(); }

 private:
  QLabel* text_;
};

/// How far long work is, and a button that stops it.
class WorkBar : public QWidget {
  Q_OBJECT

 public:
  /// The button has a tool tip, and runs a command.
  WorkBar(const RunLine& run, const char* stop_command, const char* tool_tip,
          QWidget* parent = nullptr);

  /// `done` of `total` parts of the work; a `total` of 0: nobody knows.
  void Show(const QString& text, int done, int total);

 private:
  QLabel* text_;
  QProgressBar* bar_;
};

/// "Mapping: 120 of 900 scans, 3 submaps, 1 loops, 85 scans/s"
QString TextOf(const MappingProgress& progress, double seconds);

/// Which step is looked at, how fast it plays, and what it pauses at.
class PlayBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlayBar(RunLine run, QWidget* parent = nullptr);

  void Show(const Session& session);

 private:
  void AddPauseButton();

  RunLine run_;
  QLabel* step_;
  QComboBox* speed_;
  QAction* on_loop_ = nullptr;
  QAction* on_rejection_ = nullptr;
  QDoubleSpinBox* residual_ = nullptr;
};

}  // namespace loopscope
