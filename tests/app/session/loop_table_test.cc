// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/loop_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/loop_explanation.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

/// Of all candidates, with the residuals of `state`.
Table MakeLoopTable(const Recording& recording, const MapState& state) {
  LoopTable loops;
  loops.Append(recording);
  loops.Show(recording, state);
  return loops.table();
}

double NumberAt(const Table& table, int row, const std::string& column) {
  return table.Numbers(table.ColumnOf(column))[row];
}

bool IsKnown(const Table& table, int row, const std::string& column) {
  return table.IsKnown(row, table.ColumnOf(column));
}

double ResidualMeters(const MapState& state, const LoopCandidate& loop) {
  return LoopResidual(state, loop).head<2>().norm();
}

TEST(LoopTable, HasARowForEveryCandidate) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeLoopTable(run, LastState(run));
  ASSERT_EQ(table.num_rows(), static_cast<int>(run.candidates().size()));
  for (int row = 0; row < table.num_rows(); ++row) {
    const LoopCandidate& candidate = run.candidates()[row];
    EXPECT_EQ(NumberAt(table, row, "index"), row);
    EXPECT_EQ(NumberAt(table, row, "node"), candidate.node.index);
    EXPECT_EQ(NumberAt(table, row, "submap"), candidate.submap.index);
    EXPECT_EQ(NumberAt(table, row, "considered"), candidate.considered_step);
    EXPECT_EQ(NumberAt(table, row, "applied"), candidate.applied_step);
    EXPECT_EQ(table.Text(row, table.ColumnOf("verdict")), ToString(candidate.verdict));
    EXPECT_EQ(table.Text(row, table.ColumnOf("reason")), ReasonOf(candidate));
  }
}

TEST(LoopTable, TellsOfASearchOnlyWhereThereWasOne) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeLoopTable(run, LastState(run));
  const int skipped = FirstCandidateWith(run, Verdict::kNotSampled);
  for (const char* column : {"score", "min_score", "bound", "rival", "supporters", "residual"}) {
    EXPECT_FALSE(IsKnown(table, skipped, column)) << column;
  }
  const int closed = FirstCandidateWith(run, Verdict::kAccepted);
  const LoopCandidate& loop = run.candidates()[closed];
  EXPECT_EQ(NumberAt(table, closed, "score"), loop.score);
  EXPECT_EQ(NumberAt(table, closed, "min_score"), loop.min_score);
  EXPECT_EQ(NumberAt(table, closed, "bound"), loop.score_bound);
  EXPECT_EQ(NumberAt(table, closed, "supporters"), loop.num_supporters);
  EXPECT_FALSE(IsKnown(table, closed, "rival"));
}

TEST(LoopTable, GivesTheRivalOfAnAmbiguousPlaceAndNoSupporters) {
  Recording run(ScanLog{}, Options());
  SlamUpdate update;
  update.started_submap = Submap();
  update.node = Node{0, Pose2(), SubmapId{0}, 1};
  update.candidates.resize(1);
  update.candidates[0].verdict = Verdict::kAmbiguous;
  update.candidates[0].rival_score = 0.5;
  run.Append(update);
  const Table table = MakeLoopTable(run, LastState(run));
  EXPECT_EQ(NumberAt(table, 0, "rival"), 0.5);
  EXPECT_FALSE(IsKnown(table, 0, "supporters"));
}

TEST(LoopTable, ResidualsAndDistancesAreThoseOfTheStepShown) {
  const Recording& run = SmallLoopRun();
  const int closed = FirstCandidateWith(run, Verdict::kAccepted);
  const LoopCandidate& loop = run.candidates()[closed];
  LoopTable loops;
  loops.Append(run);
  for (const int step : {loop.applied_step, run.num_steps() - 1}) {
    const MapState state = StateAfterStep(run, step);
    loops.Show(run, state);
    const Eigen::Vector3d residual = LoopResidual(state, loop);
    EXPECT_EQ(NumberAt(loops.table(), closed, "residual"), residual.head<2>().norm());
    EXPECT_EQ(NumberAt(loops.table(), closed, "residual_angle"),
              RadiansToDegrees(std::abs(residual.z())));
    const Pose2 submap_from_node = state.global_from_submap[loop.submap.index].Inverse() *
                                   state.global_from_node[loop.node.index];
    EXPECT_NEAR(NumberAt(loops.table(), closed, "distance"), submap_from_node.translation.norm(),
                1e-12);
  }
}

TEST(LoopTable, DoesNotKnowPosesOfWhatCameLater) {
  const Recording& run = SmallLoopRun();
  const int closed = FirstCandidateWith(run, Verdict::kAccepted);
  LoopTable loops;
  loops.Append(run);
  loops.Show(run, LastState(run));
  EXPECT_TRUE(IsKnown(loops.table(), closed, "residual"));
  loops.Show(run, StateAfterStep(run, run.candidates()[closed].applied_step - 1));
  EXPECT_FALSE(IsKnown(loops.table(), closed, "residual"));
  EXPECT_FALSE(IsKnown(loops.table(), closed, "residual_angle"));
  EXPECT_FALSE(IsKnown(loops.table(), closed, "distance"));
}

TEST(LoopTable, TellsWhatTheFirstOptimizationDidToALoop) {
  const Recording& run = SmallLoopRun();
  const Table table = MakeLoopTable(run, StateAfterStep(run, 0));
  double sum_before = 0.0;
  double sum_after = 0.0;
  for (int row = 0; row < table.num_rows(); ++row) {
    const LoopCandidate& loop = run.candidates()[row];
    if (loop.verdict != Verdict::kAccepted) continue;
    const double before = NumberAt(table, row, "residual_before");
    const double after = NumberAt(table, row, "residual_after");
    EXPECT_EQ(before, ResidualMeters(StateBeforeOptimization(run, loop.applied_step), loop));
    EXPECT_EQ(after, ResidualMeters(StateAfterStep(run, loop.applied_step), loop));
    sum_before += before;
    sum_after += after;
  }
  EXPECT_GT(sum_before, 2.0 * sum_after);
}

TEST(LoopTable, GrownBitByBitEqualsThatOfTheWholeRun) {
  const ScanLog log = SimulateSmallLoop().log;
  Recording run(log, SmallLoopOptions());
  Slam slam(run.log(), run.options(), 1);
  LoopTable loops;
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    run.Append(slam.AddScan(scan));
    loops.Append(run);
  }
  const Table whole = MakeLoopTable(run, LastState(run));
  loops.Show(run, LastState(run));
  ASSERT_EQ(loops.table().num_rows(), whole.num_rows());
  for (int row = 0; row < whole.num_rows(); ++row) {
    for (int column = 0; column < whole.num_columns(); ++column) {
      EXPECT_EQ(loops.table().At(row, column), whole.At(row, column)) << row << ", " << column;
    }
  }
}

}  // namespace
}  // namespace loopscope
