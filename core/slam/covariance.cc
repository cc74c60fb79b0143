// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/covariance.h"

#include "core/graph/outliers.h"
#include "core/local/used_odometry.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

MeasuredNode Measured(const Recording& recording, const OdometryOfScans& odometry, int index) {
  const Node& node = recording.nodes()[index];
  return {NodeId{index}, node.local_from_base, odometry[node.step]};
}

}  // namespace

GraphProblem GraphOf(const Recording& recording, const MapState& state) {
  GraphProblem problem{
      state.global_from_submap, state.global_from_node, ConstraintsOf(recording, state), {}};
  const OdometryOfScans odometry =
      UsedOdometry(recording.log(), recording.options().trajectory_builder_2d);
  for (int i = 1; i < state.num_nodes; ++i) {
    for (const ConsecutiveNodes& term :
         RelateConsecutive(Measured(recording, odometry, i - 1), Measured(recording, odometry, i),
                           recording.options().pose_graph.optimization_problem)) {
      problem.consecutive_nodes.push_back(term);
    }
  }
  return WithoutOutliers(problem, recording.options().pose_graph.optimization_problem.outliers);
}

std::optional<Eigen::Matrix3d> CovarianceOfNode(const Recording& recording, const MapState& state,
                                                NodeId node) {
  return CovarianceOfNode(GraphOf(recording, state),
                          recording.options().pose_graph.optimization_problem, node);
}

std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const Recording& recording, const MapState& state,
                                                  SubmapId submap) {
  return CovarianceOfSubmap(GraphOf(recording, state),
                            recording.options().pose_graph.optimization_problem, submap);
}

}  // namespace loopscope
