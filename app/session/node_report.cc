// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/session/inspection_report.h"
#include "app/session/report_rows.h"
#include "core/graph/spa_cost.h"
#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

std::string SubmapsText(const Node& node) {
  const std::string first = ToString(node.first_submap);
  return node.num_submaps == 1 ? first
                               : first + " and " + ToString(SubmapId{node.first_submap.index + 1});
}

Section NodeSection(const Recording& recording, NodeId id) {
  const Node& node = recording.node(id);
  return {"Node " + ToString(id),
          {Row("step", std::to_string(node.step)), Row("time", TimeText(recording, node.step)),
           Row("inserted into", SubmapsText(node))}};
}

Section PoseSection(const Recording& recording, const MapState& state, NodeId id) {
  const Node& node = recording.node(id);
  Section section{"Poses", {}};
  section.rows.push_back(Row("global frame", id.index < state.num_nodes
                                                 ? PoseText(state.global_from_node[id.index])
                                                 : fmt::format("none before step {}", node.step)));
  section.rows.push_back(Row("local frame", PoseText(node.local_from_base)));
  for (int i = node.first_submap.index; i < node.first_submap.index + node.num_submaps; ++i) {
    section.rows.push_back(Row("in submap " + ToString(SubmapId{i}),
                               PoseText(SubmapFromNode(recording, SubmapId{i}, id))));
  }
  return section;
}

/// Residuals of the constraints on a node that exists in `state`.
Section ConstraintSection(const Recording& recording, const MapState& state, NodeId id) {
  const Node& node = recording.node(id);
  Section section{"Residuals of its constraints", {}};
  for (int i = node.first_submap.index; i < node.first_submap.index + node.num_submaps; ++i) {
    const Eigen::Vector3d residual =
        SpaError(SubmapFromNode(recording, SubmapId{i}, id), state.global_from_submap[i],
                 state.global_from_node[id.index]);
    section.rows.push_back(Row("INTRA, submap " + ToString(SubmapId{i}), ResidualText(residual)));
  }
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.node != id || candidate.verdict != Verdict::kAccepted) continue;
    section.rows.push_back(Row("INTER, submap " + ToString(candidate.submap),
                               ResidualText(LoopResidual(state, candidate))));
  }
  return section;
}

}  // namespace

InspectionReport ReportOnNode(const Recording& recording, const MapState& state, NodeId node) {
  RequireNode(recording, node);
  InspectionReport report = {NodeSection(recording, node), PoseSection(recording, state, node),
                             MatchedPoses(recording, recording.node(node).step)};
  if (node.index < state.num_nodes) report.push_back(ConstraintSection(recording, state, node));
  report.push_back(
      {"Loop candidates", VerdictCounts(recording, state, [&](const LoopCandidate& candidate) {
         return candidate.node == node;
       })});
  report.push_back(OptionsInForce(
      recording.options(),
      {"TRAJECTORY_BUILDER_2D.motion_filter.", "TRAJECTORY_BUILDER_2D.voxel_filter_size",
       "TRAJECTORY_BUILDER_2D.loop_closure_adaptive_voxel_filter.", "POSE_GRAPH.matcher_",
       "POSE_GRAPH.optimization_problem."}));
  return report;
}

}  // namespace loopscope
