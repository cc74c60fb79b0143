// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/measured_drift.h"

#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"

namespace loopscope {

DriftShare MeasuredDrift::Predict(const GraphState& graph) const {
  std::vector<DriftShare> shares;
  for (const auto& [constraint, share] : loops_) {
    const Eigen::Vector3d residual =
        SpaError(constraint.submap_from_node, graph.global_from_submap[constraint.submap.index],
                 graph.global_from_node[constraint.node.index]);
    if (!IsOutlier(residual, outliers_)) shares.push_back(share);
  }
  return PredictDriftShare(shares, options_);
}

}  // namespace loopscope
