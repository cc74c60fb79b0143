// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/cell_history.h"

#include "core/slam/derive.h"

namespace loopscope {
namespace {

const ScanInserterOptions& InserterOptions(const Recording& recording) {
  return recording.options().trajectory_builder_2d.submaps.range_data_inserter;
}

}  // namespace

/// Calls `visit`(cell, code) for each write, in the order of insertion.
template <typename Visit>
void CellHistory::VisitWrites(const std::vector<ScanCells>& cells_of_nodes,
                              const Visit& visit) const {
  for (std::size_t i = 0; i < cells_of_nodes.size(); ++i) {
    const auto code = static_cast<std::uint32_t>(2 * i);
    for (const CellIndex cell : cells_of_nodes[i].hits) visit(cell, code + 1);
    if (!writes_misses_) continue;
    for (const CellIndex cell : cells_of_nodes[i].misses) visit(cell, code);
  }
}

CellHistory::CellHistory(const Recording& recording, SubmapId submap, int num_nodes)
    : first_node_(recording.submap(submap).first_node),
      writes_misses_(InserterOptions(recording).insert_free_space),
      hit_(InserterOptions(recording).hit_probability),
      miss_(InserterOptions(recording).miss_probability) {
  if (num_nodes < 0) num_nodes = recording.submap(submap).num_nodes;
  std::vector<ScanCells> cells;
  for (int i = 0; i < num_nodes; ++i) {
    cells.push_back(CellsOfNode(recording, submap, NodeId{first_node_.index + i}));
    box_ = Union(box_, Union(BoxOf(cells.back().hits), BoxOf(cells.back().misses)));
  }
  // Counts, and then places where the next write of each cell goes.
  begins_.assign((box_.empty() ? 0 : box_.num_cells()) + 1, 0);
  VisitWrites(cells, [&](CellIndex cell, std::uint32_t) { ++begins_[box_.FlatIndex(cell) + 1]; });
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  std::vector<std::uint32_t> next = begins_;
  writes_.resize(begins_.back());
  VisitWrites(cells, [&](CellIndex cell, std::uint32_t code) {
    writes_[next[box_.FlatIndex(cell)]++] = code;
  });
}

std::vector<CellWrite> CellHistory::WritesOf(CellIndex cell) const {
  std::vector<CellWrite> writes;
  if (box_.empty() || !box_.Contains(cell)) return writes;
  CellValue value = kUnknown;
  const int index = box_.FlatIndex(cell);
  for (std::uint32_t i = begins_[index]; i < begins_[index + 1]; ++i) {
    const bool is_hit = writes_[i] % 2 == 1;
    value = is_hit ? hit_(value) : miss_(value);
    const NodeId node{first_node_.index + static_cast<int>(writes_[i] / 2)};
    writes.push_back({node, is_hit, Odds(ProbabilityOf(value))});
  }
  return writes;
}

}  // namespace loopscope
