// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/recording.h"

#include <utility>

namespace loopscope {

void Recording::Append(SlamUpdate update) {
  const int step = num_steps();
  steps_.push_back(update.step);
  if (update.started_submap) submaps_.push_back(*update.started_submap);
  if (update.node) {
    nodes_.push_back(*update.node);
    const int first = update.node->first_submap.index;
    for (int i = first; i < first + update.node->num_submaps; ++i) ++submaps_[i].num_nodes;
  }
  if (update.finished_submap) submaps_[update.finished_submap->index].finished_step = step;
  candidates_.insert(candidates_.end(), update.candidates.begin(), update.candidates.end());
  if (update.optimization) optimizations_.push_back(std::move(*update.optimization));
}

std::optional<int> Recording::FindCandidate(SubmapId submap, NodeId node,
                                            int num_candidates) const {
  for (int i = num_candidates - 1; i >= 0; --i) {
    if (candidates_[i].submap == submap && candidates_[i].node == node) return i;
  }
  return std::nullopt;
}

std::optional<int> Recording::FindCandidate(SubmapId submap, NodeId node) const {
  return FindCandidate(submap, node, static_cast<int>(candidates_.size()));
}

}  // namespace loopscope
