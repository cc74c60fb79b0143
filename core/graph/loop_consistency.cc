// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_consistency.h"

#include <cmath>
#include <set>

namespace loopscope {

bool Agree(const LoopDrift& a, const LoopDrift& b, const LoopConsistencyOptions& options) {
  const double node_way = std::abs(a.node_way - b.node_way);
  const double submap_way = std::abs(a.submap_way - b.submap_way);
  if (node_way > options.max_way || submap_way > options.max_way) return false;
  const Pose2 difference = (a.drift * a.local_from_node).Inverse() * (b.drift * a.local_from_node);
  return std::abs(difference.rotation) <= options.max_angle &&
         difference.translation.norm() <=
             options.max_distance + options.max_distance_per_meter * (node_way + submap_way);
}

int NumSupporters(const LoopDrift& loop, const std::vector<LoopDrift>& others,
                  const LoopConsistencyOptions& options) {
  std::set<int> nodes;
  for (const LoopDrift& other : others) {
    if (other.node != loop.node && Agree(loop, other, options)) nodes.insert(other.node.index);
  }
  return static_cast<int>(nodes.size());
}

}  // namespace loopscope
