// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/submap_table.h"

#include <algorithm>

#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

constexpr Column::Kind kNumber = Column::Kind::kNumber;

/// In the order of SubmapColumns().
enum SubmapColumn { kIndex, kNodes, kFirst, kFinished, kWay, kLoops, kResidual };

std::vector<Column> SubmapColumns() {
  return {
      {"index", "", kNumber, 0, "Number of the submap."},
      {"nodes", "", kNumber, 0, "Scans inserted into it by the step shown."},
      {"first", "", kNumber, 0, "Step at which it was begun."},
      {"finished", "", kNumber, 0, "Step at which it was finished."},
      {"way", "m", kNumber, 2, "That the robot went in it, from its first node to its last."},
      {"loops", "", kNumber, 0, "Loops closed to it by the step shown."},
      {"residual", "m", kNumber, 3, "Mean error of these loops in the poses of the step shown."},
  };
}

struct LoopSum {
  int num_loops = 0;
  double meters = 0.0;  ///< sum of residuals
};

std::vector<LoopSum> SumLoops(const Recording& recording, const MapState& state) {
  std::vector<LoopSum> sums(recording.submaps().size());
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.verdict != Verdict::kAccepted) continue;
    LoopSum& sum = sums[candidate.submap.index];
    ++sum.num_loops;
    sum.meters += LoopResidual(state, candidate).head<2>().norm();
  }
  return sums;
}

/// [m] along the first `num_nodes` nodes of a submap.
double WayIn(const Recording& recording, const Submap& submap, int num_nodes) {
  double way = 0.0;
  for (int i = submap.first_node.index + 1; i < submap.first_node.index + num_nodes; ++i) {
    way += (recording.nodes()[i].local_from_base.translation -
            recording.nodes()[i - 1].local_from_base.translation)
               .norm();
  }
  return way;
}

}  // namespace

Table MakeSubmapTable(const Recording& recording, const MapState& state) {
  Table table(SubmapColumns());
  table.AddRows(static_cast<int>(recording.submaps().size()));
  const std::vector<LoopSum> loops = SumLoops(recording, state);
  for (int row = 0; row < table.num_rows(); ++row) {
    const Submap& submap = recording.submaps()[row];
    table.Set(row, kIndex, static_cast<double>(row));
    table.Set(row, kFirst, static_cast<double>(recording.node(submap.first_node).step));
    if (row >= state.num_submaps) continue;
    const int num_nodes = NumNodesOfSubmapAfterStep(recording, SubmapId{row}, state.step);
    table.Set(row, kNodes, static_cast<double>(num_nodes));
    table.Set(row, kWay, WayIn(recording, submap, num_nodes));
    table.Set(row, kLoops, static_cast<double>(loops[row].num_loops));
    if (submap.finished_step >= 0 && submap.finished_step <= state.step) {
      table.Set(row, kFinished, static_cast<double>(submap.finished_step));
    }
    if (loops[row].num_loops > 0) {
      table.Set(row, kResidual, loops[row].meters / loops[row].num_loops);
    }
  }
  return table;
}

}  // namespace loopscope
