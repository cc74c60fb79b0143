// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/cell_history.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/slam/derive.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

constexpr SubmapId kSubmap{3};

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

bool Holds(const std::vector<CellIndex>& cells, CellIndex cell) {
  return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

/// Every third column of a box with a margin around it.
std::vector<CellIndex> SomeCellsOf(const CellBox& box) {
  std::vector<CellIndex> cells;
  for (int y = box.min.y - 1; y <= box.min.y + box.height; ++y) {
    for (int x = box.min.x - 1; x <= box.min.x + box.width; x += 3) cells.push_back({x, y});
  }
  return cells;
}

TEST(CellHistoryTest, NamesTheNodesWhoseCellsHoldTheCell) {
  const CellHistory history(SmallLoop(), kSubmap);
  const Submap& submap = SmallLoop().submap(kSubmap);
  std::vector<ScanCells> cells_of_nodes;
  for (int i = 0; i < submap.num_nodes; ++i) {
    cells_of_nodes.push_back(
        CellsOfNode(SmallLoop(), kSubmap, NodeId{submap.first_node.index + i}));
  }
  int num_hits = 0;
  for (const CellIndex cell : SomeCellsOf(GridOfSubmap(SmallLoop(), kSubmap).box())) {
    std::vector<std::pair<int, bool>> expected;
    for (int i = 0; i < submap.num_nodes; ++i) {
      const bool is_hit = Holds(cells_of_nodes[i].hits, cell);
      num_hits += is_hit;
      if (is_hit || Holds(cells_of_nodes[i].misses, cell)) {
        expected.emplace_back(submap.first_node.index + i, is_hit);
      }
    }
    std::vector<std::pair<int, bool>> actual;
    for (const CellWrite& write : history.WritesOf(cell)) {
      actual.emplace_back(write.node.index, write.is_hit);
    }
    EXPECT_EQ(actual, expected) << cell.x << ", " << cell.y;
  }
  EXPECT_GT(num_hits, 20);
}

TEST(CellHistoryTest, EndsWithTheOddsOfTheGrid) {
  for (const int num_nodes : {0, 1, 5, 16}) {
    const CellHistory history(SmallLoop(), kSubmap, num_nodes);
    const ProbabilityGrid grid = GridOfSubmap(SmallLoop(), kSubmap, num_nodes);
    for (const CellIndex cell : SomeCellsOf(GridOfSubmap(SmallLoop(), kSubmap).box())) {
      const auto writes = history.WritesOf(cell);
      ASSERT_EQ(writes.empty(), !grid.known(cell));
      if (writes.empty()) continue;
      EXPECT_EQ(writes.back().odds, Odds(grid.probability(cell)));
    }
  }
}

TEST(CellHistoryTest, LeavesOutMissesThatAreNotWritten) {
  Options options = SmallLoopOptions();
  options.trajectory_builder_2d.submaps.range_data_inserter.insert_free_space = false;
  ScanLog log = SimulateSmallLoop().log;
  log.scans.resize(20);
  const Recording recording = MapLog(log, options);
  const CellHistory history(recording, SubmapId{0});
  const ScanCells cells = CellsOfNode(recording, SubmapId{0}, NodeId{0});
  EXPECT_TRUE(history.WritesOf(cells.hits.front()).front().is_hit);
  for (const CellIndex cell : cells.misses) {
    for (const CellWrite& write : history.WritesOf(cell)) EXPECT_TRUE(write.is_hit);
  }
}

}  // namespace
}  // namespace loopscope
