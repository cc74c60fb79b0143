// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/scan_match_refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/matching/scan_match_cost.h"
#include "core/matching/trust_region.h"

namespace loopscope {
namespace {

/// [m] How far the points move when the scan turns by a radian: their root mean square distance
/// from the scanner, a cell at least.
double ArmOf(const PointCloud& points_in_scan, double resolution) {
  double sum_of_squares = 0.0;
  for (const Eigen::Vector2d& point : points_in_scan) sum_of_squares += point.squaredNorm();
  return std::max(resolution,
                  std::sqrt(sum_of_squares / static_cast<double>(points_in_scan.size())));
}

}  // namespace

RefinedMatch RefineScanMatch(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                             const Eigen::Vector2d& target_translation,
                             const Pose2& submap_from_scan_start,
                             const CeresScanMatcherOptions& options) {
  assert(!points_in_scan.empty());
  const Pose2& start = submap_from_scan_start;
  const ScanMatchCost cost(points_in_scan, grid, target_translation, start.rotation, options);
  const TrustRegionMinimum minimum =
      MinimizeInTrustRegion([&cost](const Eigen::Vector3d& pose) { return cost.At(pose); },
                            {start.x(), start.y(), start.rotation},
                            {{1.0, 1.0, ArmOf(points_in_scan, grid.resolution())},
                             grid.resolution(),
                             options.max_num_iterations});
  const Eigen::Vector3d& pose = minimum.point;
  return {Pose2(pose.x(), pose.y(), NormalizeAngle(pose.z())), minimum.initial_cost,
          minimum.final_cost, minimum.num_iterations};
}

Pose2 RefinedPose(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                  const Pose2& submap_from_scan_start, const CeresScanMatcherOptions& options) {
  return RefineScanMatch(points_in_scan, grid, submap_from_scan_start.translation,
                         submap_from_scan_start, options)
      .submap_from_scan;
}

}  // namespace loopscope
