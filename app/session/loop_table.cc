// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/loop_table.h"

#include <cmath>
#include <optional>

#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

constexpr Column::Kind kNumber = Column::Kind::kNumber;
constexpr Column::Kind kText = Column::Kind::kText;

/// In the order of LoopColumns().
enum LoopColumn {
  kIndex,
  kNode,
  kSubmap,
  kVerdict,
  kScore,
  kMinScore,
  kResidual,
  kReason,
  kDistance,
  kResidualBefore,
  kResidualAfter,
  kResidualAngle,
  kBound,
  kRival,
  kSupporters,
  kConsidered,
  kApplied,
};

std::vector<Column> LoopColumns() {
  return {
      {"index", "", kNumber, 0,
       "Number of the candidate, in the order in which they were applied."},
      {"node", "", kNumber, 0, "The scan that may have been taken in the submap."},
      {"submap", "", kNumber, 0, "The finished submap in which it was searched."},
      {"verdict", "", kText, 0, "What became of the candidate."},
      {"score", "", kNumber, 3, "Mean probability at the points, at the best pose found."},
      {"min_score", "", kNumber, 3, "What the score had to beat."},
      {"residual", "m", kNumber, 3, "Error of the closed loop in the poses of the step shown."},
      {"reason", "", kText, 0, "Why it got its verdict."},
      {"distance", "m", kNumber, 2,
       "From the origin of the submap to the node, at the step shown."},
      {"residual_before", "m", kNumber, 3, "Error right before its first optimization."},
      {"residual_after", "m", kNumber, 3, "Error right after its first optimization."},
      {"residual_angle", "deg", kNumber, 2, "Likewise of the heading."},
      {"bound", "", kNumber, 3, "No pose of the search window scores more."},
      {"rival", "", kNumber, 3, "Score of a place far from the best that matches nearly as well."},
      {"supporters", "", kNumber, 0, "Other nodes with loops that say the same."},
      {"considered", "", kNumber, 0, "Step at which the pair came up."},
      {"applied", "", kNumber, 0, "Step at which the verdict was applied to the graph."},
  };
}

Cell KnownIf(bool known, double value) { return known ? Cell(value) : Cell(std::monostate()); }

double Meters(const Eigen::Vector3d& residual) { return residual.head<2>().norm(); }

/// The poses right before and after the optimization of a step, made once for all of its loops.
class Correction {
 public:
  void MoveTo(const Recording& recording, int step) {
    if (before_ && before_->step == step) return;
    before_ = StateBeforeOptimization(recording, step);
    after_ = StateAfterStep(recording, step);
  }

  const MapState& before() const { return *before_; }
  const MapState& after() const { return *after_; }

 private:
  std::optional<MapState> before_;
  std::optional<MapState> after_;
};

}  // namespace

LoopTable::LoopTable() : table_(LoopColumns()) {}

void LoopTable::Append(const Recording& recording) {
  const auto& candidates = recording.candidates();
  const int first_new = table_.num_rows();
  table_.AddRows(static_cast<int>(candidates.size()) - first_new);
  Correction correction;
  for (int row = first_new; row < table_.num_rows(); ++row) {
    const LoopCandidate& candidate = candidates[row];
    SetDecision(row, candidate);
    if (candidate.verdict != Verdict::kNotSampled) SetSearch(row, candidate);
    if (candidate.verdict != Verdict::kAccepted) continue;
    correction.MoveTo(recording, candidate.applied_step);
    table_.Set(row, kResidualBefore, Meters(LoopResidual(correction.before(), candidate)));
    table_.Set(row, kResidualAfter, Meters(LoopResidual(correction.after(), candidate)));
  }
}

void LoopTable::SetDecision(int row, const LoopCandidate& candidate) {
  table_.Set(row, kIndex, static_cast<double>(row));
  table_.Set(row, kNode, static_cast<double>(candidate.node.index));
  table_.Set(row, kSubmap, static_cast<double>(candidate.submap.index));
  table_.Set(row, kVerdict, ToString(candidate.verdict));
  table_.Set(row, kReason, ReasonOf(candidate));
  table_.Set(row, kConsidered, static_cast<double>(candidate.considered_step));
  table_.Set(row, kApplied, static_cast<double>(candidate.applied_step));
}

void LoopTable::SetSearch(int row, const LoopCandidate& candidate) {
  const bool compared_with_others =
      candidate.verdict == Verdict::kAccepted || candidate.verdict == Verdict::kInconsistent;
  table_.Set(row, kScore, candidate.score);
  table_.Set(row, kMinScore, candidate.min_score);
  table_.Set(row, kBound, candidate.score_bound);
  table_.Set(row, kRival, KnownIf(candidate.rival_score > 0.0, candidate.rival_score));
  table_.Set(row, kSupporters, KnownIf(compared_with_others, candidate.num_supporters));
}

void LoopTable::Show(const Recording& recording, const MapState& state) {
  for (int row = 0; row < table_.num_rows(); ++row) {
    const LoopCandidate& candidate = recording.candidates()[row];
    const bool applied = row < state.num_candidates;
    const bool closed = applied && candidate.verdict == Verdict::kAccepted;
    const Eigen::Vector3d residual =
        closed ? LoopResidual(state, candidate) : Eigen::Vector3d::Zero();
    const double distance = applied
                                ? (state.global_from_submap[candidate.submap.index].translation -
                                   state.global_from_node[candidate.node.index].translation)
                                      .norm()
                                : 0.0;
    table_.Set(row, kDistance, KnownIf(applied, distance));
    table_.Set(row, kResidual, KnownIf(closed, Meters(residual)));
    table_.Set(row, kResidualAngle, KnownIf(closed, RadiansToDegrees(std::abs(residual.z()))));
  }
}

}  // namespace loopscope
