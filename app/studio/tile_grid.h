// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QGridLayout>
#include <QWidget>
#include <vector>

#include "app/session/session.h"
#include "app/studio/run_line.h"
#include "app/studio/scene_worker.h"
#include "app/studio/tile.h"

namespace loopscope {

/// The views of the window: as many tiles as the session has, in rows of two.
class TileGrid : public QWidget {
  Q_OBJECT

 public:
  /// Shows `session`, and draws with `worker`; both have to live longer.
  TileGrid(const Session& session, SceneWorker* worker, const RunLine& run,
           QWidget* parent = nullptr);

  /// Asks for pictures of the session as it is now.
  void Refresh();
  /// As if nothing had been asked for yet.
  void Forget();

  /// What the active tile shows, or will.
  ViewRequest PictureOfActive() const;

 signals:
  /// What lies under the pointer, in words; empty if it is nowhere.
  void Pointed(const QString& text);
  /// The table of loops now lists what was clicked at.
  void Listed();

 private:
  void Add(int index, const RunLine& run);
  void Place();

  const Session& session_;
  SceneWorker* worker_;
  QGridLayout* grid_;
  std::vector<Tile*> tiles_;
  std::size_t num_shown_ = 0;
};

}  // namespace loopscope
