// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/io/carmen_log.h"
#include "core/matching/branch_and_bound.h"
#include "core/matching/precomputed_grids.h"
#include "core/matching/search_lattice.h"
#include "core/slam/derive.h"
#include "tests/support/mapped_log.h"
#include "tests/support/plain_branch_and_bound.h"

// The loop search against the plain one, in the same submap of the bundled log.
namespace loopscope {
namespace {

constexpr double kMinScore = 0.55;
constexpr int kDepth = 7;

/// A finished submap, and a scan that was taken in it.
struct Place {
  ProbabilityGrid grid{0.05};
  PointCloud points;
  Pose2 submap_from_scan;
};

const Place& Office() {
  static const Place place = [] {
    ScanLog log = ReadCarmenLog(LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz");
    log.scans.resize(300);
    const Recording recording = MapLog(log, LoopscopePreset());
    const NodeId node{recording.submaps()[1].first_node.index + 40};
    return Place{GridOfSubmap(recording, SubmapId{1}), LoopScanOfNode(recording, node).returns,
                 SubmapFromNode(recording, SubmapId{1}, node)};
  }();
  return place;
}

/// What is searched: windows around a guess that is off by metres, or the whole submap.
struct Task {
  double linear_window;   ///< [m]
  double angular_window;  ///< [rad]
  double min_score;
  Pose2 guess;
};

SearchOutcome Search(const BranchAndBoundMatcher& matcher, const Task& task) {
  return matcher.Search(Office().points, task.guess, task.linear_window, task.angular_window,
                        task.min_score);
}

Task TaskOf(const benchmark::State& state) {
  const Pose2& truth = Office().submap_from_scan;
  const Task near{1.0, DegreesToRadians(5.0), kMinScore, truth * Pose2(0.5, -0.4, 0.05)};
  const Task wide{7.0, DegreesToRadians(30.0), kMinScore, truth * Pose2(3.0, -2.0, 0.25)};
  Task task = state.range(0) == 0 ? near : wide;
  if (state.range(0) == 2) {
    const BranchAndBoundMatcher matcher(Office().grid, kDepth);
    task.min_score = Search(matcher, wide).best_found.score + 0.01;
  } else if (state.range(0) == 3) {
    task.linear_window = 20.0;
    task.angular_window = M_PI;
  }
  return task;
}

void NameTasks(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("1m_7m_fail_20m")->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
}

void BM_BranchAndBound(benchmark::State& state) {
  const Task task = TaskOf(state);
  const BranchAndBoundMatcher matcher(Office().grid, kDepth);
  double score = 0.0;
  for (auto _ : state) {
    const SearchOutcome outcome = Search(matcher, task);
    score = outcome.winner ? outcome.winner->score : 0.0;
  }
  state.counters["score"] = score;
}
BENCHMARK(BM_BranchAndBound)->Apply(NameTasks);

void BM_PlainBranchAndBound(benchmark::State& state) {
  const Task task = TaskOf(state);
  const PlainPrecomputedGrids grids(Office().grid, kDepth);
  const SearchWindow window =
      MakeSearchWindow(Office().points, task.guess, task.linear_window, task.angular_window, 0.05);
  double score = 0.0;
  for (auto _ : state) {
    const auto winner = PlainBranchAndBound(grids, window, Office().points, task.min_score);
    score = winner ? winner->score : 0.0;
  }
  state.counters["score"] = score;
}
BENCHMARK(BM_PlainBranchAndBound)->Apply(NameTasks);

// Those that a search asks for; the plain one needs one of each height.
void BM_PrecomputeGrids(benchmark::State& state) {
  for (auto _ : state) {
    const PrecomputedGrids grids(Office().grid, kDepth);
    benchmark::DoNotOptimize(&grids.at_height(3));
    benchmark::DoNotOptimize(&grids.swept_at_height(3));
  }
}
BENCHMARK(BM_PrecomputeGrids)->Unit(benchmark::kMicrosecond);

void BM_PlainPrecomputeGrids(benchmark::State& state) {
  for (auto _ : state) PlainPrecomputedGrids(Office().grid, kDepth);
}
BENCHMARK(BM_PlainPrecomputeGrids)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace loopscope
