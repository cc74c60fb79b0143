// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/state.h"

#include <algorithm>
#include <cassert>

namespace loopscope {
namespace {

/// Number of `items`, which are ordered by the step that `step_of` gives, up to `step`.
template <typename Item, typename StepOf>
int NumUntil(const std::vector<Item>& items, int step, const StepOf& step_of) {
  const auto end =
      std::upper_bound(items.begin(), items.end(), step,
                       [&](int wanted, const Item& item) { return wanted < step_of(item); });
  return static_cast<int>(end - items.begin());
}

/// The state after `step`, with loops and optimizations up to `last_optimized_step`.
MapState StateAt(const Recording& recording, int step, int last_optimized_step) {
  assert(0 <= step && step < recording.num_steps());
  MapState state;
  state.step = step;
  state.num_nodes = NumUntil(recording.nodes(), step, [](const Node& n) { return n.step; });
  state.num_submaps = NumUntil(recording.submaps(), step, [&](const Submap& submap) {
    return recording.node(submap.first_node).step;
  });
  state.num_candidates = NumCandidatesAfterStep(recording, last_optimized_step);
  state.num_optimizations = NumUntil(recording.optimizations(), last_optimized_step,
                                     [](const Optimization& o) { return o.step; });

  std::vector<Pose2> local_from_submap;
  for (int i = 0; i < state.num_submaps; ++i) {
    local_from_submap.push_back(recording.submaps()[i].local_from_submap);
  }
  if (state.num_optimizations > 0) {
    const Optimization& last = recording.optimizations()[state.num_optimizations - 1];
    state.global_from_submap = last.global_from_submap;
    state.global_from_node = last.global_from_node;
    const std::size_t newest = last.global_from_submap.size() - 1;
    state.global_from_local = last.global_from_submap[newest] * local_from_submap[newest].Inverse();
  }
  for (int i = static_cast<int>(state.global_from_submap.size()); i < state.num_submaps; ++i) {
    state.global_from_submap.push_back(state.global_from_local * local_from_submap[i]);
  }
  for (int i = static_cast<int>(state.global_from_node.size()); i < state.num_nodes; ++i) {
    state.global_from_node.push_back(state.global_from_local *
                                     recording.nodes()[i].local_from_base);
  }
  state.global_from_base = GlobalFromBase(recording, state, step);
  return state;
}

}  // namespace

int NumCandidatesAfterStep(const Recording& recording, int step) {
  return NumUntil(recording.candidates(), step,
                  [](const LoopCandidate& c) { return c.applied_step; });
}

MapState StateAfterStep(const Recording& recording, int step) {
  return StateAt(recording, step, step);
}

MapState StateBeforeOptimization(const Recording& recording, int step) {
  return StateAt(recording, step, step - 1);
}

Pose2 GlobalFromBase(const Recording& recording, const MapState& state, int step) {
  const Pose2& local_from_base = recording.step(step).local_from_base;
  const auto& nodes = recording.nodes();
  const int num_nodes =
      std::min(state.num_nodes, NumUntil(nodes, step, [](const Node& n) { return n.step; }));
  if (num_nodes == 0) return state.global_from_local * local_from_base;
  return state.global_from_node[num_nodes - 1] *
         (nodes[num_nodes - 1].local_from_base.Inverse() * local_from_base);
}

}  // namespace loopscope
