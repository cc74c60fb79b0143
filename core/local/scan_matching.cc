// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/scan_matching.h"

namespace loopscope {

ScanMatch MatchScan(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                    const Pose2& submap_from_base_prior, const LocalSlamOptions& options) {
  ScanMatch match;
  Pose2 start = submap_from_base_prior;
  if (options.use_online_correlative_scan_matching) {
    start = MatchCorrelative(points_in_base, grid, submap_from_base_prior,
                             options.real_time_correlative_scan_matcher)
                .submap_from_scan;
    match.submap_from_base_correlative = start;
  }
  match.submap_from_base = MatchWithCeres(points_in_base, grid, submap_from_base_prior.translation,
                                          start, options.ceres_scan_matcher)
                               .submap_from_scan;
  return match;
}

}  // namespace loopscope
