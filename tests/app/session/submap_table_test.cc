// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/submap_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/loop_explanation.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

double NumberAt(const Table& table, int row, const std::string& column) {
  return table.Numbers(table.ColumnOf(column))[row];
}

bool IsKnown(const Table& table, int row, const std::string& column) {
  return table.IsKnown(row, table.ColumnOf(column));
}

TEST(SubmapTable, HasNodesStepsAndWayOfEverySubmap) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeSubmapTable(run, LastState(run));
  ASSERT_EQ(table.num_rows(), static_cast<int>(run.submaps().size()));
  for (int row = 0; row < table.num_rows(); ++row) {
    const Submap& submap = run.submaps()[row];
    EXPECT_EQ(NumberAt(table, row, "index"), row);
    EXPECT_EQ(NumberAt(table, row, "nodes"), submap.num_nodes);
    EXPECT_EQ(NumberAt(table, row, "first"), run.node(submap.first_node).step);
    EXPECT_EQ(IsKnown(table, row, "finished"), submap.finished_step >= 0);
  }
  EXPECT_EQ(NumberAt(table, 0, "finished"), run.submaps()[0].finished_step);
  // Sixteen nodes at most 0.2 m apart: no straight line is longer than the way.
  const Submap& first = run.submaps()[0];
  const double straight = (run.nodes()[first.num_nodes - 1].local_from_base.translation -
                           run.nodes()[0].local_from_base.translation)
                              .norm();
  EXPECT_GE(NumberAt(table, 0, "way"), straight);
  EXPECT_LT(NumberAt(table, 0, "way"), 1.5 * straight);
}

TEST(SubmapTable, CountsTheLoopsClosedToASubmapAndAveragesTheirResiduals) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const Table table = MakeSubmapTable(run, state);
  const int submap = run.candidates()[FirstCandidateWith(run, Verdict::kAccepted)].submap.index;
  int num_loops = 0;
  double sum = 0.0;
  for (const LoopCandidate& candidate : run.candidates()) {
    if (candidate.verdict != Verdict::kAccepted || candidate.submap.index != submap) continue;
    ++num_loops;
    sum += LoopResidual(state, candidate).head<2>().norm();
  }
  EXPECT_EQ(NumberAt(table, submap, "loops"), num_loops);
  EXPECT_NEAR(NumberAt(table, submap, "residual"), sum / num_loops, 1e-12);
  const int newest = table.num_rows() - 1;
  EXPECT_EQ(NumberAt(table, newest, "loops"), 0);
  EXPECT_FALSE(IsKnown(table, newest, "residual"));
}

TEST(SubmapTable, ShowsASubmapAsItWasAtTheStep) {
  const Recording& run = SmallLoopRun();
  const int step = run.submaps()[1].finished_step - 1;
  const Table table = MakeSubmapTable(run, StateAfterStep(run, step));
  EXPECT_TRUE(IsKnown(table, 0, "finished"));
  EXPECT_FALSE(IsKnown(table, 1, "finished"));
  EXPECT_EQ(NumberAt(table, 1, "nodes"), run.submaps()[1].num_nodes - 1);
  const int later = table.num_rows() - 1;
  EXPECT_TRUE(IsKnown(table, later, "first"));
  for (const char* column : {"nodes", "finished", "way", "loops", "residual"}) {
    EXPECT_FALSE(IsKnown(table, later, column)) << column;
  }
}

}  // namespace
}  // namespace loopscope
