// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/timeline_widget.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace loopscope {
namespace {

constexpr int kMargin = 10;
constexpr int kNames = 96;  // width of the names of the rows [px]
constexpr int kRow = 13;    // height [px]
constexpr int kRuler = 16;  // height of the row of times
constexpr int kHandle = 6;  // half of its width

struct Row {
  Event::Kind kind;
  const char* name;
  QColor color;
};

const std::array<Row, 4> kRows{{{Event::Kind::kSubmapFinished, "submaps", QColor(0x8a93a6)},
                                {Event::Kind::kLoopClosed, "loops closed", QColor(0x3fae5a)},
                                {Event::Kind::kLoopRefused, "loops refused", QColor(0xe0483e)},
                                {Event::Kind::kOptimization, "optimizations", QColor(0x3d7edb)}}};

/// The smallest of 1, 2, 5, 10, ... that is at least `least`.
double RoundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

TimelineWidget::TimelineWidget(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
  setToolTip("Drag to look at another scan");
}

QSize TimelineWidget::sizeHint() const {
  return {600, kRuler + kRow * static_cast<int>(kRows.size()) + kMargin};
}

QSize TimelineWidget::minimumSizeHint() const { return {300, sizeHint().height()}; }

void TimelineWidget::Show(const Session& session) {
  session_ = session.has_steps() ? &session : nullptr;
  const int num_scans =
      session_ == nullptr ? 0 : static_cast<int>(session.recording().log().scans.size());
  const int num_steps = session.last_step() + 1;
  const std::size_t num_events = session.timeline().events().size();
  const bool has_grown =
      num_scans != num_scans_ || num_events != num_events_ || num_steps != num_steps_;
  if (!has_grown && step_ == session.state().step) return;
  step_ = session.state().step;
  num_scans_ = num_scans;
  num_steps_ = num_steps;
  num_events_ = num_events;
  if (has_grown) ticks_ = QPixmap();
  update();
}

double TimelineWidget::XOf(int step) const {
  const double span = width() - kNames - 2.0 * kMargin;
  return kMargin + kNames + span * step / std::max(1, num_scans_ - 1);
}

int TimelineWidget::StepAt(double x) const {
  const double span = width() - kNames - 2.0 * kMargin;
  const double step = (x - kMargin - kNames) / span * std::max(1, num_scans_ - 1);
  return std::clamp(static_cast<int>(std::lround(step)), 0, std::max(0, num_steps_ - 1));
}

void TimelineWidget::DrawTicks() {
  ticks_ = QPixmap(size() * devicePixelRatioF());
  ticks_.setDevicePixelRatio(devicePixelRatioF());
  ticks_.fill(Qt::transparent);
  QPainter painter(&ticks_);
  const QColor ink = palette().color(QPalette::WindowText);
  QColor faint = ink;
  faint.setAlpha(28);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(small);
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    const int top = kRuler + kRow * static_cast<int>(i);
    painter.setPen(ink);
    painter.drawText(QRect(kMargin, top, kNames - 8, kRow), Qt::AlignRight | Qt::AlignVCenter,
                     kRows[i].name);
    painter.fillRect(QRectF(XOf(0), top + 1, XOf(num_scans_ - 1) - XOf(0), kRow - 2), faint);
  }
  for (const Event& event : session_->timeline().events()) {
    const auto row = std::find_if(kRows.begin(), kRows.end(),
                                  [&](const Row& r) { return r.kind == event.kind; });
    if (row == kRows.end()) continue;
    const int top = kRuler + kRow * static_cast<int>(row - kRows.begin());
    painter.fillRect(QRectF(std::floor(XOf(event.step)), top + 1, 1.0, kRow - 2), row->color);
  }
  const auto& scans = session_->recording().log().scans;
  const double start = scans.front().time;
  const auto is_earlier = [](const LaserScan& a, const LaserScan& b) { return a.time < b.time; };
  const double end = std::max_element(scans.begin(), scans.end(), is_earlier)->time;
  const double duration = std::max(1e-9, end - start);
  const double every = RoundStep(duration * 70.0 / std::max(1.0, XOf(num_scans_ - 1) - XOf(0)));
  double next = 0.0;
  painter.setPen(ink);
  for (int step = 0; step < num_scans_; ++step) {
    const double seconds = scans[step].time - start;
    if (seconds < next) continue;
    next = every * std::floor(seconds / every);  // there may have been a pause
    const double x = XOf(step);
    painter.drawLine(QPointF(x, kRuler - 3), QPointF(x, kRuler));
    painter.drawText(QRectF(x + 2, 0, 80, kRuler - 2), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(fmt::format("{:g} s", next)));
    next += every;
  }
}

void TimelineWidget::paintEvent(QPaintEvent*) {
  if (session_ == nullptr || num_scans_ == 0) return;
  if (ticks_.isNull()) DrawTicks();
  QPainter painter(this);
  painter.drawPixmap(0, 0, ticks_);
  painter.setRenderHint(QPainter::Antialiasing);
  const double x = XOf(step_);
  const QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(QPen(accent, 2.0));
  painter.drawLine(QPointF(x, kRuler - 2), QPointF(x, height() - 4));
  painter.setBrush(accent);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygonF{
      {QPointF(x - kHandle, kRuler - 10), QPointF(x + kHandle, kRuler - 10), QPointF(x, kRuler)}});
}

void TimelineWidget::resizeEvent(QResizeEvent*) { ticks_ = QPixmap(); }

void TimelineWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) ticks_ = QPixmap();
  QWidget::changeEvent(event);
}

void TimelineWidget::mousePressEvent(QMouseEvent* event) {
  if (session_ != nullptr && event->button() == Qt::LeftButton) emit Sought(StepAt(event->x()));
}

void TimelineWidget::mouseMoveEvent(QMouseEvent* event) {
  if (session_ != nullptr && (event->buttons() & Qt::LeftButton) != 0) {
    emit Sought(StepAt(event->x()));
  }
}

}  // namespace loopscope
