// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/node_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spa_cost.h"
#include "core/slam/derive.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

double NumberAt(const Table& table, int row, const std::string& column) {
  return table.Numbers(table.ColumnOf(column))[row];
}

TEST(NodeTable, HasScanAndPoseOfEveryNode) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const Table table = MakeNodeTable(run, state);
  ASSERT_EQ(table.num_rows(), static_cast<int>(run.nodes().size()));
  for (int row = 0; row < table.num_rows(); ++row) {
    const int step = run.nodes()[row].step;
    EXPECT_EQ(NumberAt(table, row, "index"), row);
    EXPECT_EQ(NumberAt(table, row, "step"), step);
    EXPECT_EQ(NumberAt(table, row, "time"), run.log().scans[step].time - run.log().scans[0].time);
    const Pose2& pose = state.global_from_node[row];
    EXPECT_EQ(NumberAt(table, row, "x"), pose.x());
    EXPECT_EQ(NumberAt(table, row, "y"), pose.y());
    EXPECT_EQ(NumberAt(table, row, "heading"), RadiansToDegrees(pose.rotation));
  }
}

TEST(NodeTable, TellsHowFarTheMatchMovedTheScanFromWhereItWasPredicted) {
  ScanLog log;
  log.scans.resize(1);
  Recording run(log, Options());
  SlamUpdate update;
  update.step.local_from_base_prior = Pose2(1.0, 1.0, 3.1);
  update.step.local_from_base = Pose2(1.3, 1.4, -3.1);
  update.started_submap = Submap();
  update.node = Node{0, update.step.local_from_base, SubmapId{0}, 1};
  run.Append(update);
  const Table table = MakeNodeTable(run, LastState(run));
  EXPECT_NEAR(NumberAt(table, 0, "moved"), 0.5, 1e-12);
  EXPECT_NEAR(NumberAt(table, 0, "moved_angle"), RadiansToDegrees(2.0 * M_PI - 6.2), 1e-9);
}

TEST(NodeTable, CountsTheLoopsClosedFromANode) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeNodeTable(run, LastState(run));
  const NodeId node = run.candidates()[FirstCandidateWith(run, Verdict::kAccepted)].node;
  const auto num_loops =
      std::count_if(run.candidates().begin(), run.candidates().end(), [&](const auto& candidate) {
        return candidate.node == node && candidate.verdict == Verdict::kAccepted;
      });
  EXPECT_EQ(NumberAt(table, node.index, "loops"), num_loops);
  const Table before = MakeNodeTable(run, StateAfterStep(run, run.nodes()[node.index].step));
  EXPECT_EQ(NumberAt(before, 0, "loops"), 0);
}

TEST(NodeTable, GivesTheLargerErrorOfTheTwoSubmapsOfANode) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const Table table = MakeNodeTable(run, state);
  for (int row = 0; row < table.num_rows(); ++row) {
    const Node& node = run.nodes()[row];
    double largest = 0.0;
    for (int i = 0; i < node.num_submaps; ++i) {
      const SubmapId submap{node.first_submap.index + i};
      const Eigen::Vector3d error =
          SpaError(SubmapFromNode(run, submap, NodeId{row}), state.global_from_submap[submap.index],
                   state.global_from_node[row]);
      largest = std::max(largest, error.head<2>().norm());
    }
    EXPECT_NEAR(NumberAt(table, row, "residual"), largest, 1e-12);
  }
}

TEST(NodeTable, DoesNotKnowPosesOfWhatCameLater) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeNodeTable(run, StateAfterStep(run, run.nodes()[5].step));
  for (const char* column : {"x", "y", "heading", "loops", "residual"}) {
    EXPECT_TRUE(table.IsKnown(5, table.ColumnOf(column))) << column;
    EXPECT_FALSE(table.IsKnown(6, table.ColumnOf(column))) << column;
  }
  EXPECT_TRUE(table.IsKnown(6, table.ColumnOf("moved")));
}

}  // namespace
}  // namespace loopscope
