// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/tile.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <fmt/format.h>

#include "app/session/commands.h"

namespace loopscope {
namespace {

// The commands that show the views, in the order of the list.
const std::vector<ViewKind> kKinds{ViewKind::kMap,   ViewKind::kSubmap, ViewKind::kUpdate,
                                   ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph};

constexpr int kTextHeight = 12;  // [px] as in the rest of the window

}  // namespace

Tile::Tile(int index, SceneWorker* worker, RunLine run, QWidget* parent)
    : QWidget(parent), index_(index), worker_(worker), run_(std::move(run)) {
  kinds_ = new QComboBox(this);
  for (const ViewKind kind : kKinds) {
    const Command& command = CommandNamed("view." + ToString(kind));
    kinds_->addItem(QString::fromStdString(command.title));
  }
  kinds_->setFocusPolicy(Qt::NoFocus);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  view_ = new ViewWidget(this);

  auto* const bar = new QHBoxLayout;
  bar->setContentsMargins(6, 4, 6, 4);
  bar->addWidget(kinds_);
  bar->addWidget(message_, 1);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(bar);
  column->addWidget(view_, 1);

  connect(kinds_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    Activate();
    run_("view." + ToString(kKinds[i]));
  });
  connect(view_, &ViewWidget::CameraRested, this, [this](double x, double y, double width) {
    Activate();
    run_(fmt::format("camera.set {} {} {}", x, y, width));
  });
  connect(view_, &ViewWidget::Clicked, this, [this](const QPoint&) { Activate(); });
  connect(view_, &ViewWidget::DoubleClicked, this, [this](const QPoint&) {
    Activate();
    run_("camera.fit");
  });
  connect(view_, &ViewWidget::Hovered, this, &Tile::Hover);
  connect(view_, &ViewWidget::Left, this, [this] { emit Pointed(""); });
}

void Tile::Activate() { run_("tile.select " + std::to_string(index_)); }

void Tile::Show(const Session& session) {
  const ViewKind kind = session.state().tiles[index_];
  const auto place = std::find(kKinds.begin(), kKinds.end(), kind);
  kinds_->setCurrentIndex(static_cast<int>(place - kKinds.begin()));
  const bool is_active = session.state().active_tile == index_ && session.state().tiles.size() > 1;
  QFont font = kinds_->font();
  font.setBold(is_active);
  kinds_->setFont(font);
  if (!session.has_steps() || !isVisible()) return;
  ViewRequest request = session.RequestOf(index_);
  constexpr int kMinWidth = 320, kMinHeight = 240;  // of a picture
  request.width = std::max(kMinWidth, view_->width());
  request.height = std::max(kMinHeight, view_->height());
  request.text_height = kTextHeight;
  if (asked_ == request) return;
  asked_ = request;
  worker_->Ask(index_, request, view_->device_pixels());
}

void Tile::TakeScene() {
  std::optional<DrawnScene> drawn = worker_->Take(index_);
  if (!drawn) return;
  message_->setText(QString::fromStdString(drawn->error));
  if (!drawn->scene) return;
  const bool same_view = shown_ && shown_->view == drawn->request.view;
  shown_ = drawn->request;
  view_->Show(std::move(*drawn->scene), same_view);
}

void Tile::Forget() {
  asked_.reset();
  shown_.reset();
}

void Tile::Hover(const QPoint& position) {
  const auto place = view_->PlaceAt(position);
  emit Pointed(place ? QString::fromStdString(
                           fmt::format("{:.2f} m, {:.2f} m", place->point.x(), place->point.y()))
                     : QString());
}

}  // namespace loopscope
