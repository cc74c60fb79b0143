// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/id.h"
#include "render/view.h"

namespace loopscope {

/// What a view shows of its map.
struct ViewCamera {
  Eigen::Vector2d center;                                 ///< [m] in the frame of the view
  double width_in_meters = 1.0;                           ///< of the main panel
  std::optional<double> height_in_meters = std::nullopt;  ///< with it, the least of both
};
bool operator==(const ViewCamera& a, const ViewCamera& b);

/// How a view is drawn, wherever it is shown.
struct ViewSettings {
  std::optional<std::set<LayerKind>> layers;  ///< the view's own if left out
  std::map<LayerKind, double> opacities;      ///< in [0, 1]; 1 if left out
  std::optional<ViewCamera> camera;           ///< all of the map if left out
};
bool operator==(const ViewSettings& a, const ViewSettings& b);

enum class TableKind { kLoops, kSubmaps, kNodes };

/// "loops", "submaps" or "nodes". Throws std::invalid_argument naming these for anything else.
TableKind TableKindFromName(const std::string& name);
std::string ToString(TableKind kind);

/// Which rows of a table are listed, and in which order.
struct TableSettings {
  std::string filter;   ///< see table_filter.h; empty lists all
  std::string sort_by;  ///< name of a column; empty keeps the order of the recording
  bool descending = false;
};
bool operator==(const TableSettings& a, const TableSettings& b);

/// What a person looks at: all that pictures and lists depend on beside the recording.
struct SessionState {
  int step = 0;
  std::vector<ViewKind> tiles{ViewKind::kMap};  ///< 1, 2 or 4 views, from the upper left
  int active_tile = 0;
  std::optional<NodeId> node;            ///< selected,
  std::optional<SubmapId> submap;        ///< likewise; with both, the pair of them
  std::vector<int> loops;                ///< candidates that are marked beside it
  SearchFilter search;                   ///< of the search of the pair
  ChartKind chart = ChartKind::kScores;  ///< what the view chart shows
  std::map<ViewKind, ViewSettings> views;
  /// Most pairs are skipped by sampling: they are not listed unless asked for.
  std::map<TableKind, TableSettings> tables{
      {TableKind::kLoops, {"verdict != \"not sampled\"", "", false}}};
  Theme theme = Theme::kDefault;  ///< hues of the pictures: this or kColorBlind
};
bool operator==(const SessionState& a, const SessionState& b);
inline bool operator!=(const SessionState& a, const SessionState& b) { return !(a == b); }

}  // namespace loopscope
