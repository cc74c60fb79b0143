// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <benchmark/benchmark.h>

#include "core/graph/loop_search.h"
#include "core/io/carmen_log.h"
#include "core/matching/search_lattice.h"
#include "core/slam/derive.h"
#include "tests/support/ceres_graph.h"
#include "tests/support/ceres_scan_match.h"
#include "tests/support/exhaustive_search.h"
#include "tests/support/mapped_log.h"
#include "tests/support/plain_branch_and_bound.h"
#include "tests/support/plain_scan_insertion.h"

namespace loopscope {
namespace {

// The whole bundled log, mapped by one thread; and what mapping it is made of, done by the plain
// implementations on the same inputs: each match, insertion, search and optimization of the run.

const ScanLog& Office() {
  static const ScanLog log = ReadCarmenLog(LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz");
  return log;
}

const Recording& Run() {
  static const Recording recording = MapLog(Office(), LoopscopePreset());
  return recording;
}

void BM_MapLog(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(MapLog(Office(), LoopscopePreset()));
}
BENCHMARK(BM_MapLog)->Unit(benchmark::kMillisecond);

/// The pose that MatchCorrelative finds, by scoring all.
Pose2 PlainMatchCorrelative(const MatchReplay& match,
                            const CorrelativeScanMatcherOptions& options) {
  const SearchWindow window =
      MakeSearchWindow(match.points, match.submap_from_base_prior, options.linear_search_window,
                       options.angular_search_window, match.grid.resolution());
  SearchResult best;
  ForEachPose(window, [&](CellIndex offset, int angle_index) {
    const Pose2 pose = PlainPose(window, offset, angle_index);
    const double delta =
        options.translation_delta_cost_weight * window.resolution * std::hypot(offset.x, offset.y) +
        options.rotation_delta_cost_weight * window.angular_step * std::abs(angle_index);
    const double score = PlainScore(match.points, pose, match.grid) * std::exp(-delta * delta);
    if (score > best.score) best = {pose, score};
  });
  return best.submap_from_scan;
}

/// Times `action(match)` for each match of the run.
template <typename Action>
void ForEachMatch(benchmark::State& state, const Action& action) {
  for (auto _ : state) {
    for (int step = 0; step < Run().num_steps(); ++step) {
      state.PauseTiming();
      const auto match = ReplayMatch(Run(), step);
      state.ResumeTiming();
      if (match) action(*match);
    }
  }
}

void BM_PlainCorrelativeMatches(benchmark::State& state) {
  ForEachMatch(state, [&](const MatchReplay& match) {
    benchmark::DoNotOptimize(PlainMatchCorrelative(
        match, Run().options().trajectory_builder_2d.real_time_correlative_scan_matcher));
  });
}
BENCHMARK(BM_PlainCorrelativeMatches)->Unit(benchmark::kMillisecond)->Iterations(1);

void BM_PlainCeresMatches(benchmark::State& state) {
  ForEachMatch(state, [&](const MatchReplay& match) {
    const Pose2& prior = match.submap_from_base_prior;
    benchmark::DoNotOptimize(
        MatchWithAutomaticDerivatives(match.points, match.grid, prior.translation,
                                      match.submap_from_base_correlative.value_or(prior),
                                      Run().options().trajectory_builder_2d.ceres_scan_matcher));
  });
}
BENCHMARK(BM_PlainCeresMatches)->Unit(benchmark::kMillisecond)->Iterations(1);

void BM_PlainInsertions(benchmark::State& state) {
  const SubmapsOptions& options = Run().options().trajectory_builder_2d.submaps;
  for (auto _ : state) {
    for (int submap = 0; submap < static_cast<int>(Run().submaps().size()); ++submap) {
      PlainGrid grid(options.grid_resolution);
      const Submap& record = Run().submaps()[submap];
      for (int i = 0; i < record.num_nodes; ++i) {
        const NodeId node{record.first_node.index + i};
        grid.Insert(Transform(SubmapFromNode(Run(), SubmapId{submap}, node),
                              RangeDataOfStep(Run(), Run().node(node).step)),
                    options.range_data_inserter.hit_probability,
                    options.range_data_inserter.miss_probability);
      }
    }
  }
}
BENCHMARK(BM_PlainInsertions)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Of one submap after the other, so that its grids are made once.
void BM_PlainLoopSearches(benchmark::State& state) {
  const ConstraintBuilderOptions& options = Run().options().pose_graph.constraint_builder;
  int num_searches = 0;
  for (auto _ : state) {
    for (int submap = 0; submap < static_cast<int>(Run().submaps().size()); ++submap) {
      const ProbabilityGrid grid = GridOfSubmap(Run(), SubmapId{submap});
      std::optional<PlainPrecomputedGrids> grids;
      for (const LoopCandidate& candidate : Run().candidates()) {
        if (candidate.submap.index != submap || candidate.verdict == Verdict::kNotSampled) continue;
        if (!grids) {
          grids.emplace(grid, options.fast_correlative_scan_matcher.branch_and_bound_depth);
        }
        const PointCloud points = LoopScanOfNode(Run(), candidate.node).returns;
        const SearchWindow window = MakeSearchWindow(
            points, candidate.submap_from_node_guess, candidate.linear_search_window,
            candidate.angular_search_window, grid.resolution());
        const auto winner = PlainBranchAndBound(*grids, window, points, candidate.min_score);
        ++num_searches;
        if (!winner) continue;
        const Pose2& found = winner->submap_from_scan;
        benchmark::DoNotOptimize(MatchWithAutomaticDerivatives(points, grid, found.translation,
                                                               found, options.ceres_scan_matcher));
      }
    }
  }
  state.counters["searches"] = num_searches;
}
BENCHMARK(BM_PlainLoopSearches)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Each from the poses before it, with all loops until then; no rounds of leaving some out.
void BM_PlainOptimizations(benchmark::State& state) {
  const OptimizationProblemOptions& options = Run().options().pose_graph.optimization_problem;
  for (auto _ : state) {
    for (const Optimization& optimization : Run().optimizations()) {
      state.PauseTiming();
      const MapState before = StateBeforeOptimization(Run(), optimization.step);
      const MapState after = StateAfterStep(Run(), optimization.step);
      const GraphProblem problem{
          before.global_from_submap, before.global_from_node, ConstraintsOf(Run(), after), {}};
      state.ResumeTiming();
      benchmark::DoNotOptimize(SolveGraphWithCeres(problem, options, optimization.num_iterations));
    }
  }
}
BENCHMARK(BM_PlainOptimizations)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace loopscope
