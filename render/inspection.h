// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/id.h"
#include "render/annotation.h"
#include "render/view.h"

namespace loopscope {

/// Loops whose score or residual lies in a range.
struct LoopRange {
  std::string quantity;  ///< "score" or "residual"
  double begin = 0.0;    ///< [m] of a residual
  double end = 0.0;      ///< likewise
};

/// What lies at a point of a panel.
struct Finding {
  std::optional<NodeId> node;
  std::optional<SubmapId> submap;
  std::vector<Fact> facts;
  // Of charts: of a point its step, and the loop candidate that it stands for; of a bar its range.
  std::optional<int> step = std::nullopt;
  std::optional<int> loop = std::nullopt;
  std::optional<LoopRange> range = std::nullopt;
};

/// Tells what lies where in a picture. It is derived once, like the scene and on whatever thread,
/// and then answers fast enough to be asked at every move of a mouse, also while the recording
/// grows. It touches nothing of VTK but the boxes of the scene.
class Inspector {
 public:
  /// For the `scene` that BuildScene made of `request` with `cache`, which is not kept; throws as
  /// it does.
  Inspector(DerivedCache* cache, const ViewRequest& request, const Scene& scene);

  /// In map and graph the nearest node within `tolerance` [m]; else the nearest of the constraints
  /// that are drawn, INTER before INTRA; else the nearest origin of a submap. In submap a node
  /// likewise, and the cell. In update and match the cell, in search the block under the point, in
  /// chart the point near it or the bar under it. A point is in the coordinates of the panel: [m],
  /// or those of the chart. Nothing if nothing is there, and in time.
  std::optional<Finding> WhatIsAt(int panel, const Eigen::Vector2d& point, double tolerance) const {
    return look_(panel, point, tolerance);
  }

 private:
  std::function<std::optional<Finding>(int, const Eigen::Vector2d&, double)> look_;
};

}  // namespace loopscope
