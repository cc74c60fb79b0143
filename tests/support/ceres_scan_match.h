// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/matching/scan_match_refinement.h"

namespace loopscope {

/// RefineScanMatch as Cartographer has it: a problem of Ceres with automatic derivatives, and its
/// own bicubic interpolation.
RefinedMatch MatchWithAutomaticDerivatives(const PointCloud& points_in_scan,
                                           const ProbabilityGrid& grid,
                                           const Eigen::Vector2d& target_translation,
                                           const Pose2& submap_from_scan_start,
                                           const CeresScanMatcherOptions& options);

}  // namespace loopscope
