// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "app/mapping.h"
#include "app/session/session.h"
#include "app/studio/tile.h"

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

/// How far mapping is, and a button that stops it.
class MappingBar : public QWidget {
  Q_OBJECT

 public:
  explicit MappingBar(const RunLine& run, QWidget* parent = nullptr);

  void Show(const MappingProgress& progress, double seconds);

 private:
  QLabel* text_;
  QProgressBar* bar_;
};

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
