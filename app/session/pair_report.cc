// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/session/inspection_report.h"
#include "app/session/report_rows.h"
#include "core/slam/loop_explanation.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

Section PairSection(const Recording& recording, SubmapId submap, NodeId node,
                    const LoopCandidate* candidate) {
  Section section{"Node " + ToString(node) + ", submap " + ToString(submap), {}};
  if (candidate == nullptr) {
    section.rows = {Row("verdict", "none: the pair never was a candidate")};
    return section;
  }
  section.rows = {Row("candidate", std::to_string(candidate - recording.candidates().data())),
                  Row("verdict", ToString(candidate->verdict)),
                  Row("considered at step", std::to_string(candidate->considered_step)),
                  Row("applied at step", std::to_string(candidate->applied_step))};
  return section;
}

Section GateSection(const LoopExplanation& explanation) {
  Section section{"Gates", {}};
  for (const LoopCheck& check : explanation.checks) {
    section.rows.push_back({check.what, check.value, check.expected, check.passed});
  }
  section.rows.push_back(Row("answer", explanation.answer));
  return section;
}

/// Poses of the node in the submap, of a pair that was searched.
Section SearchSection(const LoopCandidate& candidate) {
  Section section{"Search (frame of the submap)", {}};
  section.rows = {
      Row("window", candidate.whole_submap
                        ? "the whole submap"
                        : fmt::format("{:.2f} m, {:.2f} deg each way around the estimate",
                                      candidate.linear_search_window,
                                      RadiansToDegrees(candidate.angular_search_window))),
      Row("estimate", PoseText(candidate.submap_from_node_guess)),
      Row("found", PoseText(candidate.submap_from_node_searched)),
      Row("refined", PoseText(candidate.submap_from_node)),
      Row("from estimate to refined",
          DifferenceText(candidate.submap_from_node_guess, candidate.submap_from_node))};
  return section;
}

/// Of a loop that was closed.
Section ResidualSection(const Recording& recording, const MapState& state,
                        const LoopCandidate& loop) {
  const auto residual_in = [&](const MapState& poses) {
    return ResidualText(LoopResidual(poses, loop));
  };
  return {"Residual",
          {Row("before its first optimization",
               residual_in(StateBeforeOptimization(recording, loop.applied_step))),
           Row("after it", residual_in(StateAfterStep(recording, loop.applied_step))),
           Row(fmt::format("at step {}", state.step),
               loop.applied_step <= state.step ? residual_in(state) : "not yet in the graph")}};
}

}  // namespace

InspectionReport ReportOnPair(const Recording& recording, const MapState& state, SubmapId submap,
                              NodeId node) {
  RequireSubmap(recording, submap);
  RequireNode(recording, node);
  const std::optional<int> index = recording.FindCandidate(submap, node);
  const LoopCandidate* const candidate = index ? &recording.candidates()[*index] : nullptr;
  InspectionReport report = {PairSection(recording, submap, node, candidate),
                             GateSection(ExplainLoop(recording, submap, node))};
  if (candidate != nullptr && candidate->verdict != Verdict::kNotSampled) {
    report.push_back(SearchSection(*candidate));
  }
  if (candidate != nullptr && candidate->verdict == Verdict::kAccepted) {
    report.push_back(ResidualSection(recording, state, *candidate));
  }
  report.push_back(OptionsInForce(recording.options(), {"POSE_GRAPH.constraint_builder."}));
  return report;
}

}  // namespace loopscope
