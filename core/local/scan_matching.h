// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/grid/probability_grid.h"
#include "core/local/local_slam_options.h"

namespace loopscope {

struct ScanMatch {
  std::optional<Pose2> submap_from_base_correlative;  ///< if that matcher is switched on
  Pose2 submap_from_base;                             ///< after (CS)
};

/// Local scan matching: the correlative matcher, if it is switched on, then (CS).
ScanMatch MatchScan(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                    const Pose2& submap_from_base_prior, const LocalSlamOptions& options);

}  // namespace loopscope
