// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/slam/recording.h"
#include "render/charts/chart_data.h"
#include "render/derived_cache.h"
#include "render/palette.h"
#include "render/scene.h"
#include "render/search_filter.h"
#include "render/view_kinds.h"

namespace loopscope {

/// Node and submap of a loop candidate.
struct LoopPair {
  NodeId node;
  SubmapId submap;
};
bool operator==(const LoopPair& a, const LoopPair& b);

/// What to draw of a recording, and how. Whatever is left out is chosen by the view.
struct ViewRequest {
  ViewKind view = ViewKind::kMap;
  std::optional<int> step;  ///< the state after this scan; the last one
  /// The subject of update and match (then its step is the default) and search; selected in the
  /// others, in chart as a pair.
  std::optional<NodeId> node;
  std::optional<SubmapId>
      submap;                    ///< likewise of submap, update and search; selected in the others
  std::vector<LoopPair> marked;  ///< loops that are marked beside it in map, graph, time and chart
  SearchFilter search;           ///< for search only
  int width = 1280;              ///< [px], kMinPictureWidth or more
  int height = 720;              ///< [px], likewise
  Theme theme = Theme::kDefault;
  std::string title;                          ///< instead of the view's own
  std::optional<std::set<LayerKind>> layers;  ///< those to draw, a part of LayersOf(view)
  std::map<LayerKind, double> opacities;      ///< in [0, 1], of layers of the view; 1 if left out
  std::optional<Eigen::Vector2d> center;      ///< [m] of the main panel, in the frame of the view
  std::optional<double> width_in_meters;      ///< of the main panel,
  std::optional<double> height_in_meters;     ///< likewise: where both are given, the least of each
  std::optional<double> azimuth;              ///< [deg] for time: from which side, see SideView
  std::optional<double> elevation;            ///< [deg] for time: 0 from the side to 90 from above
  ChartKind chart = ChartKind::kScores;       ///< for chart
  bool plain = false;              ///< only title and maps: no legend, colour bars and numbers
  std::optional<int> text_height;  ///< [px], 8 to 200; grows with the picture if left out
};

bool operator==(const ViewRequest& a, const ViewRequest& b);

/// Pixels of the scene for one of the picture, each way: 2 up to 3840x2160, for smooth edges; 1 for
/// larger ones, of which four times as many do not fit in memory.
int OversamplingOf(const ViewRequest& request);

/// At the step that is asked for there is nothing yet of what the view shows, while at another
/// there may be.
class NothingToShow : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The picture of a view: a pure function of its arguments. The frame is the map's for map and
/// graph, and that of the submap shown for the others. Throws std::invalid_argument that says what
/// was expected if the recording does not have what is asked for, NothingToShow if not at that
/// step.
Scene BuildScene(const Recording& recording, const ViewRequest& request, int oversampling = 1);

/// The same picture of the recording of `cache`, which makes a series of pictures faster.
Scene BuildScene(DerivedCache* cache, const ViewRequest& request, int oversampling = 1);

}  // namespace loopscope
