// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/node_table.h"

#include <algorithm>
#include <cmath>

#include "core/slam/derive.h"

namespace loopscope {
namespace {

constexpr Column::Kind kNumber = Column::Kind::kNumber;

/// In the order of NodeColumns().
enum NodeColumn {
  kIndex,
  kStep,
  kTime,
  kX,
  kY,
  kHeading,
  kMoved,
  kMovedAngle,
  kLoops,
  kResidual,
};

std::vector<Column> NodeColumns() {
  return {
      {"index", "", kNumber, 0, "Number of the node."},
      {"step", "", kNumber, 0, "The scan that it is."},
      {"time", "s", kNumber, 2, "Of the scan, since the first scan of the log."},
      {"x", "m", kNumber, 2, "In the global frame, at the step shown."},
      {"y", "m", kNumber, 2, "Likewise."},
      {"heading", "deg", kNumber, 1, "Likewise, counter-clockwise from the x axis."},
      {"moved", "m", kNumber, 3, "How far the scan match lies from the predicted pose."},
      {"moved_angle", "deg", kNumber, 2, "How far it is turned from the predicted pose."},
      {"loops", "", kNumber, 0, "Loops closed from it by the step shown."},
      {"residual", "m", kNumber, 3,
       "Larger error of its INTRA_SUBMAP constraints in the poses of the step shown."},
  };
}

std::vector<int> CountLoops(const Recording& recording, const MapState& state) {
  std::vector<int> counts(recording.nodes().size(), 0);
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.verdict == Verdict::kAccepted) ++counts[candidate.node.index];
  }
  return counts;
}

/// [m], of eq. 5, the larger one of the submaps that the node was inserted into.
double IntraResidual(const Recording& recording, const MapState& state, NodeId id) {
  const Node& node = recording.node(id);
  double largest = 0.0;
  for (int i = node.first_submap.index; i < node.first_submap.index + node.num_submaps; ++i) {
    const Pose2 submap_from_node =
        state.global_from_submap[i].Inverse() * state.global_from_node[id.index];
    const Pose2 inserted = SubmapFromNode(recording, SubmapId{i}, id);
    largest = std::max(largest, (inserted.translation - submap_from_node.translation).norm());
  }
  return largest;
}

void SetScan(int row, const Recording& recording, Table* table) {
  const auto& scans = recording.log().scans;
  const int step = recording.nodes()[row].step;
  const Pose2 prior_from_match =
      recording.step(step).local_from_base_prior.Inverse() * recording.step(step).local_from_base;
  table->Set(row, kIndex, static_cast<double>(row));
  table->Set(row, kStep, static_cast<double>(step));
  table->Set(row, kTime, scans[step].time - scans.front().time);
  table->Set(row, kMoved, prior_from_match.translation.norm());
  table->Set(row, kMovedAngle, RadiansToDegrees(std::abs(prior_from_match.rotation)));
}

void SetPose(int row, const Pose2& global_from_node, Table* table) {
  table->Set(row, kX, global_from_node.x());
  table->Set(row, kY, global_from_node.y());
  table->Set(row, kHeading, RadiansToDegrees(global_from_node.rotation));
}

}  // namespace

Table MakeNodeTable(const Recording& recording, const MapState& state) {
  Table table(NodeColumns());
  table.AddRows(static_cast<int>(recording.nodes().size()));
  const std::vector<int> num_loops = CountLoops(recording, state);
  for (int row = 0; row < table.num_rows(); ++row) {
    SetScan(row, recording, &table);
    if (row >= state.num_nodes) continue;
    SetPose(row, state.global_from_node[row], &table);
    table.Set(row, kLoops, static_cast<double>(num_loops[row]));
    table.Set(row, kResidual, IntraResidual(recording, state, NodeId{row}));
  }
  return table;
}

}  // namespace loopscope
