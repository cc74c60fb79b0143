// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/graph_solver.h"

namespace loopscope {

/// Whether the residual of eq. 5 [m, m, rad] of a loop is beyond what `options` leave it. False if
/// they are off.
bool IsOutlier(const Eigen::Vector3d& residual, const OutlierOptions& options);

/// Whether `loop` is one at these poses.
bool IsOutlier(const Constraint& loop, const std::vector<Pose2>& global_from_submap,
               const std::vector<Pose2>& global_from_node, const OutlierOptions& options);

/// The constraints without the loops that are outliers at these poses.
std::vector<Constraint> WithoutOutliers(std::vector<Constraint> constraints,
                                        const std::vector<Pose2>& global_from_submap,
                                        const std::vector<Pose2>& global_from_node,
                                        const OutlierOptions& options);

/// The problem without the loops that are outliers at its poses.
GraphProblem WithoutOutliers(const GraphProblem& problem, const OutlierOptions& options);

/// (SPA) without the loops that contradict the others: those that eq. 4 leaves with too large a
/// residual are taken out and the others solved again, until none goes or comes back, or
/// `max_num_rounds` times. A local minimum of truncated losses; Yang et al., "Graduated
/// Non-Convexity for Robust Spatial Perception", RA-L 2020, who start from squares, where this
/// starts from Huber's loss. Of the first `num_judged` constraints, loops that are outliers at the
/// poses of the problem are left out from the start, and return if the others agree with them after
/// all. `initial_cost` and `final_cost` are of the loops that are left at the end.
GraphSolution SolveGraphWithoutOutliers(const GraphProblem& problem, std::size_t num_judged,
                                        const OptimizationProblemOptions& options,
                                        const SolverLimits& limits, int max_num_rounds);

}  // namespace loopscope
