// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/matching/correlative_scan_matcher.h"
#include "core/matching/motion_prior.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// The most probable pose of a scan that was taken after a motion of which only `prior` is known,
/// from `submap_from_before` on: of all poses on the lattice of eqs. 7 to 10 that the prior
/// reaches, the one with the highest mean_k M_nearest(T_xi h_k), in 256 steps, times its weight.
/// After Olson, "Real-Time Correlative Scan Matching", ICRA 2009, by branch and bound of one
/// branching. `points_in_scan` must not be empty.
CorrelativeMatch MatchWithPrior(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                const Pose2& submap_from_before, const MotionPrior& prior);

}  // namespace loopscope
