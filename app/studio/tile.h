// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "app/session/session.h"
#include "app/studio/run_line.h"
#include "app/studio/scene_worker.h"
#include "app/studio/search_bar.h"
#include "app/studio/view_widget.h"

namespace loopscope {

/// One of the views of the window, with a list of views to choose from above it.
class Tile : public QWidget {
  Q_OBJECT

 public:
  /// Draws with `worker`, which has to live longer.
  Tile(int index, SceneWorker* worker, RunLine run, QWidget* parent = nullptr);

  /// Asks for the picture of the session if it is another than that which is shown.
  void Show(const Session& session);
  /// Puts the picture that the worker has drawn into the view.
  void TakeScene();
  /// As if nothing had been asked for yet.
  void Forget();

  ViewWidget* view() { return view_; }
  const std::optional<ViewRequest>& asked() const { return asked_; }

 signals:
  /// What lies under the pointer, in words; empty if it is nowhere.
  void Pointed(const QString& text);
  /// The table of loops now lists what was clicked at.
  void Listed();

 private:
  void MakeLists();
  void MakeSearchBar();
  void Arrange();
  void ConnectView();
  void ShowLists(const Session& session);
  void Activate();
  void Hover(const QPoint& position);
  /// Selects what was clicked at, where that is a thing of the whole map or the run.
  void Select(const QPoint& position);
  /// Goes to a point of a chart; shows all of any other view.
  void GoTo(const QPoint& position);
  /// Asked for before the view was resized: another picture is on its way.
  bool IsOfOtherSize(const ViewRequest& request) const;
  std::optional<Finding> FindAt(const QPoint& position) const;

  int index_;
  SceneWorker* worker_;
  RunLine run_;
  QComboBox* kinds_ = nullptr;
  QComboBox* charts_ = nullptr;
  QLabel* message_ = nullptr;
  SearchBar* search_ = nullptr;
  ViewWidget* view_ = nullptr;
  std::optional<ViewRequest> asked_;
  std::optional<ViewRequest> shown_;
  std::optional<Inspector> inspector_;  // of what is shown
  SearchSize search_size_;              // likewise
};

}  // namespace loopscope
