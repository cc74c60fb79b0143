// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/tile_grid.h"

namespace loopscope {
namespace {

constexpr int kMaxTiles = 4;

}  // namespace

TileGrid::TileGrid(const Session& session, SceneWorker* worker, const RunLine& run, QWidget* parent)
    : QWidget(parent), session_(session), worker_(worker), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(1);
  for (int i = 0; i < kMaxTiles; ++i) Add(i, run);
  connect(worker, &SceneWorker::Drawn, this, [this](int tile) { tiles_[tile]->TakeScene(); });
}

void TileGrid::Add(int index, const RunLine& run) {
  auto* const tile = new Tile(index, worker_, run, this);
  tiles_.push_back(tile);
  connect(tile, &Tile::Pointed, this, &TileGrid::Pointed);
  connect(tile, &Tile::Listed, this, &TileGrid::Listed);
  connect(tile->view(), &ViewWidget::Resized, this, [this, tile, index] {
    if (static_cast<std::size_t>(index) < num_shown_) tile->Show(session_);
  });
}

void TileGrid::Refresh() {
  const std::size_t count = session_.state().tiles.size();
  if (count != num_shown_) {
    num_shown_ = count;
    Place();
  }
  for (std::size_t i = 0; i < count; ++i) tiles_[i]->Show(session_);
}

void TileGrid::Forget() {
  for (Tile* const tile : tiles_) tile->Forget();
}

ViewRequest TileGrid::PictureOfActive() const {
  const int tile = session_.state().active_tile;
  return tiles_[tile]->asked().value_or(session_.RequestOf(tile));
}

void TileGrid::Place() {
  for (const int i : {0, 1}) {
    grid_->setRowStretch(i, 0);
    grid_->setColumnStretch(i, 0);
  }
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    grid_->removeWidget(tiles_[i]);
    tiles_[i]->setVisible(i < num_shown_);
    if (i >= num_shown_) continue;
    const int row = static_cast<int>(i) / 2, column = static_cast<int>(i) % 2;
    grid_->addWidget(tiles_[i], row, column);
    grid_->setRowStretch(row, 1);
    grid_->setColumnStretch(column, 1);
  }
}

}  // namespace loopscope
