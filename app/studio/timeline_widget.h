// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPixmap>
#include <QWidget>

#include "app/session/session.h"

namespace loopscope {

/// All steps of a recording from left to right, with a row of ticks for each kind of event, and
/// the step that is looked at. Dragging seeks.
class TimelineWidget : public QWidget {
  Q_OBJECT

 public:
  explicit TimelineWidget(QWidget* parent = nullptr);

  void Show(const Session& session);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void Sought(int step);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  double XOf(int step) const;
  int StepAt(double x) const;
  void DrawTicks();

  const Session* session_ = nullptr;
  int step_ = -1;
  int num_steps_ = 0;
  int num_scans_ = 0;
  std::size_t num_events_ = 0;
  QPixmap ticks_;
};

}  // namespace loopscope
