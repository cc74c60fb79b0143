// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/session/inspection_report.h"
#include "app/session/report_rows.h"
#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

Section SubmapSection(const Recording& recording, const MapState& state, SubmapId id) {
  const Submap& submap = recording.submap(id);
  const int num_nodes = NumNodesOfSubmapAfterStep(recording, id, state.step);
  const bool finished = submap.finished_step >= 0 && submap.finished_step <= state.step;
  return {"Submap " + ToString(id),
          {Row("begun at step", std::to_string(recording.node(submap.first_node).step)),
           Row("finished at step", finished ? std::to_string(submap.finished_step) : "not yet"),
           Row("nodes", num_nodes == 0 ? "none yet"
                                       : fmt::format("{}, from {} on", num_nodes,
                                                     ToString(submap.first_node)))}};
}

Section PoseSection(const Recording& recording, const MapState& state, SubmapId id) {
  const Submap& submap = recording.submap(id);
  return {"Poses",
          {Row("global frame",
               id.index < state.num_submaps
                   ? PoseText(state.global_from_submap[id.index])
                   : fmt::format("none before step {}", recording.node(submap.first_node).step)),
           Row("local frame", PoseText(submap.local_from_submap))}};
}

/// Mean and largest residual of the loops closed to a submap.
std::vector<ReportRow> LoopResidualRows(const Recording& recording, const MapState& state,
                                        SubmapId id) {
  int num_loops = 0;
  double sum = 0.0;
  double largest = -1.0;
  NodeId largest_node;
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.submap != id || candidate.verdict != Verdict::kAccepted) continue;
    const double residual = LoopResidual(state, candidate).head<2>().norm();
    ++num_loops;
    sum += residual;
    if (residual <= largest) continue;
    largest = residual;
    largest_node = candidate.node;
  }
  if (num_loops == 0) return {};
  return {
      Row("mean residual", fmt::format("{:.3f} m", sum / num_loops)),
      Row("largest residual", fmt::format("{:.3f} m, node {}", largest, ToString(largest_node)))};
}

}  // namespace

InspectionReport ReportOnSubmap(const Recording& recording, const MapState& state,
                                SubmapId submap) {
  RequireSubmap(recording, submap);
  Section loops{"Loop candidates",
                VerdictCounts(recording, state, [&](const LoopCandidate& candidate) {
                  return candidate.submap == submap;
                })};
  for (ReportRow& row : LoopResidualRows(recording, state, submap)) {
    loops.rows.push_back(std::move(row));
  }
  return {SubmapSection(recording, state, submap), PoseSection(recording, state, submap),
          std::move(loops),
          OptionsInForce(recording.options(), {"TRAJECTORY_BUILDER_2D.submaps."})};
}

}  // namespace loopscope
