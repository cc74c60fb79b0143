// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/docks.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <map>

#include "app/studio/theme.h"

namespace loopscope {
namespace {

constexpr int kTitleHeight = 18;    // [px]
constexpr int kRightWidth = 360;    // [px] of the docks on the right, on the first day
constexpr int kBottomHeight = 200;  // [px]

QToolButton* TitleButton(const char* glyph, const char* what, QWidget* parent) {
  auto* const button = new QToolButton(parent);
  button->setAutoRaise(true);
  button->setFixedSize(kTitleHeight, kTitleHeight);
  button->setText(glyph);
  button->setToolTip(what);
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

/// What a dock is dragged at, with a button that tears it off and one that closes it.
QWidget* MakeTitle(QDockWidget* dock) {
  auto* const title = new QWidget(dock);
  auto* const name = new QLabel(dock->windowTitle(), title);
  QFont small = name->font();
  small.setPixelSize(11);
  name->setFont(small);
  name->setEnabled(false);  // faint
  auto* const tear_off = TitleButton("❐", "Tear off, or dock again", title);
  auto* const close = TitleButton("×", "Close; the menu View shows it again", title);
  QObject::connect(tear_off, &QToolButton::clicked, dock,
                   [dock] { dock->setFloating(!dock->isFloating()); });
  QObject::connect(close, &QToolButton::clicked, dock, &QWidget::close);
  auto* const row = new QHBoxLayout(title);
  row->setContentsMargins(6, 0, 2, 0);
  row->setSpacing(0);
  row->addWidget(name, 1);
  row->addWidget(tear_off);
  row->addWidget(close);
  return title;
}

}  // namespace

QDockWidget* Docks::Add(const char* title, QWidget* content, Qt::DockWidgetArea area) {
  auto* const dock = new QDockWidget(title, window_);
  dock->setObjectName(title);
  dock->setWidget(content);
  dock->setTitleBarWidget(MakeTitle(dock));
  docks_.push_back(dock);
  areas_.push_back(area);
  return dock;
}

void Docks::Arrange() {
  std::map<Qt::DockWidgetArea, QDockWidget*> first;
  for (std::size_t i = 0; i < docks_.size(); ++i) {
    QDockWidget* const dock = docks_[i];
    dock->setFloating(false);
    window_->addDockWidget(areas_[i], dock);
    dock->show();
    const auto [place, is_new] = first.emplace(areas_[i], dock);
    if (!is_new) window_->tabifyDockWidget(place->second, dock);
  }
  for (const auto& [area, dock] : first) {
    dock->raise();
    const bool is_below = area == Qt::BottomDockWidgetArea;
    window_->resizeDocks({dock}, {is_below ? kBottomHeight : kRightWidth},
                         is_below ? Qt::Vertical : Qt::Horizontal);
  }
}

}  // namespace loopscope
