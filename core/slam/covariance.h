// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/graph/graph_solver.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// The sum of eq. 4 that an optimization of `state` would minimize, at its poses.
GraphProblem GraphOf(const Recording& recording, const MapState& state);

/// Covariance [m, m, rad] of the pose of a node or submap in the global frame, given that submap 0
/// is where it is; see CovarianceOfNode of the graph solver.
std::optional<Eigen::Matrix3d> CovarianceOfNode(const Recording& recording, const MapState& state,
                                                NodeId node);
std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const Recording& recording, const MapState& state,
                                                  SubmapId submap);

}  // namespace loopscope
