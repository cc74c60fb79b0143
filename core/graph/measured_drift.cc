// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/measured_drift.h"

#include "core/graph/outliers.h"

namespace loopscope {

DriftShare MeasuredDrift::Predict(const GraphState& graph) const {
  std::vector<DriftShare> shares;
  for (const auto& [constraint, share] : loops_) {
    if (!IsOutlier(constraint, graph.global_from_submap, graph.global_from_node, outliers_)) {
      shares.push_back(share);
    }
  }
  return PredictDriftShare(shares, options_);
}

}  // namespace loopscope
