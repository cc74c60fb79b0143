// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "app/studio/run_line.h"
#include "app/studio/scene_worker.h"
#include "render/search_filter.h"

namespace loopscope {

/// Sliders over a loop search: the order in which its tree was visited, height and angle.
class SearchBar : public QWidget {
  Q_OBJECT

 public:
  explicit SearchBar(RunLine run, QWidget* parent = nullptr);

  /// The sliders cannot be moved if the search has no visits.
  void Show(const SearchSize& size, const SearchFilter& filter);

 private:
  /// A slider one end of which means all.
  struct Part {
    QLabel* label = nullptr;
    QSlider* slider = nullptr;
  };

  Part Add(const char* command, bool all_is_right);

  RunLine run_;
  Part visits_;
  Part height_;
  Part angle_;
  bool is_showing_ = false;
};

}  // namespace loopscope
