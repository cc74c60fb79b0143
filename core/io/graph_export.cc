// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/graph_export.h"

#include <iterator>

#include <fmt/format.h>

#include "core/graph/outliers.h"
#include "core/io/replace_file.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

std::string ToText(const Pose2& pose) {
  return fmt::format("{:.9f} {:.9f} {:.9f}", pose.x(), pose.y(), pose.rotation);
}

}  // namespace

void ExportGraph(const Recording& recording, const MapState& state, const std::string& path) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (int i = 0; i < state.num_submaps; ++i) {
    fmt::format_to(out, "VERTEX_SE2 {} {}\n", i, ToText(state.global_from_submap[i]));
  }
  for (int i = 0; i < state.num_nodes; ++i) {
    fmt::format_to(out, "VERTEX_SE2 {} {}\n", state.num_submaps + i,
                   ToText(state.global_from_node[i]));
  }
  if (state.num_submaps > 0) text += "FIX 0\n";
  const OutlierOptions& outliers = recording.options().pose_graph.optimization_problem.outliers;
  for (const Constraint& constraint :
       WithoutOutliers(ConstraintsOf(recording, state), state.global_from_submap,
                       state.global_from_node, outliers)) {
    const double translation = constraint.translation_weight * constraint.translation_weight;
    const double rotation = constraint.rotation_weight * constraint.rotation_weight;
    fmt::format_to(out, "EDGE_SE2 {} {} {} {} 0 0 {} 0 {}\n", constraint.submap.index,
                   state.num_submaps + constraint.node.index, ToText(constraint.submap_from_node),
                   translation, translation, rotation);
  }
  ReplaceFile(path, text);
}

}  // namespace loopscope
