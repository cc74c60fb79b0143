// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/bars.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QWidgetAction>

#include <fmt/format.h>

#include "app/studio/theme.h"

namespace loopscope {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), text_(new QLabel(this)) {
  setStyleSheet(
      "loopscope--MessageBar { background: #fff3cd; border-bottom: 1px solid #e0c66c; }"
      "QLabel { color: #4a3b00; } QToolButton { border: none; color: #4a3b00; }");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* const close = new QToolButton(this);
  close->setText("Close");
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 8, 6);
  row->addWidget(text_, 1);
  row->addWidget(close);
  hide();
}

void MessageBar::Tell(const QString& text) {
  text_->setText(text);
  setVisible(!text.isEmpty());
}

WorkBar::WorkBar(const RunLine& run, const char* stop_command, const char* tool_tip,
                 QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), bar_(new QProgressBar(this)) {
  bar_->setFixedWidth(180);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(10);
  auto* const stop = new QToolButton(this);
  stop->setText("Stop");
  stop->setToolTip(tool_tip);
  connect(stop, &QToolButton::clicked, this, [run, stop_command] { run(stop_command); });
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(text_);
  row->addWidget(bar_);
  row->addWidget(stop);
  hide();
}

void WorkBar::Show(const QString& text, int done, int total) {
  text_->setText(text);
  bar_->setMaximum(total);
  bar_->setValue(done);
  show();
}

QString TextOf(const MappingProgress& progress, double seconds) {
  const double rate = seconds > 0.0 ? progress.num_steps / seconds : 0.0;
  return QString::fromStdString(fmt::format(
      "Mapping: {} of {} scans, {} submaps, {} loops, {:.0f} scans/s", progress.num_steps,
      progress.num_scans, progress.num_submaps, progress.num_loops, rate));
}

PlayBar::PlayBar(RunLine run, QWidget* parent)
    : QWidget(parent), run_(std::move(run)), step_(new QLabel(this)), speed_(new QComboBox(this)) {
  for (const int speed : {1, 5, 20, 50, 100, 200, 500, 1000}) {
    speed_->addItem(QString("%1 scans/s").arg(speed), speed);
  }
  speed_->setFocusPolicy(Qt::NoFocus);
  speed_->setToolTip("How fast it plays");
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int i) { run_("play.speed " + std::to_string(speed_->itemData(i).toInt())); });
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 0);
  row->addWidget(speed_);
  AddPauseButton();
  row->addSpacing(8);
  row->addWidget(step_);
}

void PlayBar::AddPauseButton() {
  auto* const button = new QToolButton(this);
  button->setText("Pause on");
  button->setToolTip("Events at which playing pauses");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  on_loop_ = menu->addAction("closed loops");
  on_rejection_ = menu->addAction("refused loops");
  for (QAction* const action : {on_loop_, on_rejection_}) action->setCheckable(true);
  connect(on_loop_, &QAction::triggered, this, [this] { run_("pause.on_loop"); });
  connect(on_rejection_, &QAction::triggered, this, [this] { run_("pause.on_rejection"); });

  residual_ = new QDoubleSpinBox(menu);
  residual_->setRange(0.0, 100.0);
  residual_->setSingleStep(0.1);
  residual_->setSuffix(" m");
  residual_->setPrefix("residual above ");
  residual_->setSpecialValueText("no residual");
  connect(residual_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) {
            run_(value > 0.0 ? fmt::format("pause.residual {}", value) : "pause.residual");
          });
  auto* const spin = new QWidgetAction(menu);
  spin->setDefaultWidget(residual_);
  menu->addAction(spin);
  button->setMenu(menu);
  layout()->addWidget(button);
}

void PlayBar::Show(const Session& session) {
  const int speed = speed_->findData(static_cast<int>(session.scans_per_second()));
  speed_->setCurrentIndex(speed);
  on_loop_->setChecked(session.pause_conditions().on_loop);
  on_rejection_->setChecked(session.pause_conditions().on_rejection);
  if (!session.has_steps()) {
    step_->clear();
    return;
  }
  const auto& scans = session.recording().log().scans;
  const int step = session.state().step;
  step_->setText(
      QString::fromStdString(fmt::format("scan <b>{}</b> of {} · {:.1f} s", step, scans.size() - 1,
                                         scans[step].time - scans[0].time)));
}

}  // namespace loopscope
