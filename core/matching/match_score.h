// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// How well a scan fits: 1/K sum_k M_nearest(T_xi h_k), in [0.1, 0.9]. `points_in_scan` must not be
/// empty.
double MeanProbability(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                       const ProbabilityGrid& grid);

/// Whether the scan fits worse a little ahead and a little behind: along the smooth walls of a
/// corridor it does not. `points_in_scan` must not be empty.
bool HoldsAhead(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                const ProbabilityGrid& grid);

/// Of the points of a scan that lie in cells that are known.
struct KnownScore {
  int num_points = 0;
  double mean_probability = 0.0;  ///< 0 if there is none
};
KnownScore ScoreOfKnown(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                        const ProbabilityGrid& grid);

}  // namespace loopscope
