// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/session/inspection_report.h"
#include "app/session/report_rows.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

std::string OutcomeText(const Step& step) {
  switch (step.outcome) {
    case StepOutcome::kInserted:
      return "became node " + ToString(*step.node);
    case StepOutcome::kMotionFiltered:
      return "matched, but too near to the node before it";
    case StepOutcome::kNoReturns:
      return "nothing in range to match with";
  }
  return "";
}

Section ScanSection(const Recording& recording, const MapState& state) {
  const int num_scans = static_cast<int>(recording.log().scans.size());
  return {fmt::format("Step {}", state.step),
          {Row("scans of the log", std::to_string(num_scans)),
           Row("time", TimeText(recording, state.step)),
           Row("stamp", fmt::format("{:.6f} s", recording.log().scans[state.step].time)),
           Row("outcome", OutcomeText(recording.step(state.step))),
           Row("robot (global frame)", PoseText(state.global_from_base))}};
}

/// What happened at this step, or nothing.
Section CausedSection(const Recording& recording, const MapState& state) {
  Section section{"Caused", {}};
  for (int i = 0; i < state.num_submaps; ++i) {
    const Submap& submap = recording.submaps()[i];
    if (recording.node(submap.first_node).step == state.step) {
      section.rows.push_back(Row("submap begun", ToString(SubmapId{i})));
    }
    if (submap.finished_step == state.step) {
      section.rows.push_back(Row("submap finished", ToString(SubmapId{i})));
    }
  }
  for (ReportRow& row : VerdictCounts(recording, state, [&](const LoopCandidate& candidate) {
         return candidate.applied_step == state.step;
       })) {
    if (row.value != "0") section.rows.push_back(Row("loops " + row.name, row.value));
  }
  if (state.num_optimizations == 0) return section;
  const Optimization& last = recording.optimizations()[state.num_optimizations - 1];
  if (last.step == state.step) {
    section.rows.push_back(
        Row(last.final ? "final optimization" : "optimization",
            fmt::format("cost {:.4g} to {:.4g} in {} iterations", last.initial_cost,
                        last.final_cost, last.num_iterations)));
  }
  return section;
}

Section SoFarSection(const Recording& recording, const MapState& state) {
  Section section{"So far",
                  {Row("nodes", std::to_string(state.num_nodes)),
                   Row("submaps", std::to_string(state.num_submaps)),
                   Row("optimizations", std::to_string(state.num_optimizations))}};
  for (ReportRow& row : VerdictCounts(recording, state, [](const auto&) { return true; })) {
    section.rows.push_back(Row("loops " + row.name, row.value));
  }
  return section;
}

}  // namespace

InspectionReport ReportOnStep(const Recording& recording, const MapState& state) {
  InspectionReport report = {ScanSection(recording, state), MatchedPoses(recording, state.step)};
  Section caused = CausedSection(recording, state);
  if (!caused.rows.empty()) report.push_back(std::move(caused));
  report.push_back(SoFarSection(recording, state));
  report.push_back(OptionsInForce(
      recording.options(),
      {"use_odometry", "TRAJECTORY_BUILDER_2D.use_",
       "TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.",
       "TRAJECTORY_BUILDER_2D.ceres_scan_matcher.", "TRAJECTORY_BUILDER_2D.recovery.",
       "TRAJECTORY_BUILDER_2D.motion_filter.", "POSE_GRAPH.optimize_every_"}));
  return report;
}

Section ReportOnMatch(const Recording& recording, int step) {
  Section section{"Fit of the scan", {}};
  const auto replay = ReplayMatch(recording, step);
  if (!replay) {
    section.rows.push_back(Row("matched against", "nothing: first scan, or too few returns"));
    return section;
  }
  const std::string walls = replay->wide_walls ? ", walls a cell wider" : "";
  section.rows = {Row("matched against", "submap " + ToString(replay->submap) + walls),
                  Row("points", std::to_string(replay->points.size())),
                  Row("score where predicted", fmt::format("{:.3f}", replay->prior_score)),
                  Row("score where matched", fmt::format("{:.3f}", replay->score))};
  return section;
}

}  // namespace loopscope
