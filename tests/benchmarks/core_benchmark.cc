// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "core/grid/ray_cast.h"
#include "core/grid/scan_inserter.h"
#include "core/io/carmen_log.h"
#include "core/matching/correlative_scan_matcher.h"
#include "core/matching/scan_match_refinement.h"
#include "core/slam/derive.h"
#include "tests/support/ceres_graph.h"
#include "tests/support/ceres_scan_match.h"
#include "tests/support/large_recording.h"
#include "tests/support/mapped_log.h"
#include "tests/support/plain_scan_insertion.h"

namespace loopscope {
namespace {

std::string BundledLog() { return LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz"; }

// The first scans of the bundled log, mapped.
const Recording& Office() {
  static const Recording recording = [] {
    ScanLog log = ReadCarmenLog(BundledLog());
    log.scans.resize(300);
    return MapLog(log, LoopscopePreset());
  }();
  return recording;
}

// A scan somewhere in the middle of a submap.
const MatchReplay& Match() {
  static const MatchReplay match = *ReplayMatch(Office(), 200);
  return match;
}

void BM_ReadCarmenLog(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ReadCarmenLog(BundledLog()));
}
BENCHMARK(BM_ReadCarmenLog)->Unit(benchmark::kMillisecond);

void BM_MapFirstScans(benchmark::State& state) {
  const int num_threads = static_cast<int>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(MapLog(Office().log(), LoopscopePreset(), num_threads));
  }
  state.SetItemsProcessed(state.iterations() * Office().num_steps());
}
BENCHMARK(BM_MapFirstScans)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_CastRays(benchmark::State& state) {
  const RangeData range_data = RangeDataOfStep(Office(), 200);
  for (auto _ : state) benchmark::DoNotOptimize(CastRays(range_data, 0.05));
}
BENCHMARK(BM_CastRays)->Unit(benchmark::kMicrosecond);

void BM_GridOfSubmap(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(GridOfSubmap(Office(), SubmapId{1}));
}
BENCHMARK(BM_GridOfSubmap)->Unit(benchmark::kMillisecond);

void BM_MatchCorrelative(benchmark::State& state) {
  const CorrelativeScanMatcherOptions options;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        MatchCorrelative(Match().points, Match().grid, Match().submap_from_base_prior, options));
  }
}
BENCHMARK(BM_MatchCorrelative)->Unit(benchmark::kMicrosecond);

void BM_RefineScanMatch(benchmark::State& state) {
  const CeresScanMatcherOptions options;
  const Pose2& prior = Match().submap_from_base_prior;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        RefineScanMatch(Match().points, Match().grid, prior.translation, prior, options));
  }
}
BENCHMARK(BM_RefineScanMatch)->Unit(benchmark::kMicrosecond);

void BM_PlainRefineScanMatch(benchmark::State& state) {
  const CeresScanMatcherOptions options;
  const Pose2& prior = Match().submap_from_base_prior;
  for (auto _ : state) {
    benchmark::DoNotOptimize(MatchWithAutomaticDerivatives(Match().points, Match().grid,
                                                           prior.translation, prior, options));
  }
}
BENCHMARK(BM_PlainRefineScanMatch)->Unit(benchmark::kMicrosecond);

// Into two submaps, as each scan is.
void BM_InsertScan(benchmark::State& state) {
  const RangeData range_data = RangeDataOfStep(Office(), 200);
  const ScanInserter inserter(ScanInserterOptions{});
  ProbabilityGrid first(0.05);
  ProbabilityGrid second(0.05);
  for (auto _ : state) {
    const ScanCells cells = CastRays(range_data, 0.05);
    inserter.Insert(cells, &first);
    inserter.Insert(cells, &second);
  }
}
BENCHMARK(BM_InsertScan)->Unit(benchmark::kMicrosecond);

void BM_PlainInsertScan(benchmark::State& state) {
  const RangeData range_data = RangeDataOfStep(Office(), 200);
  const ScanInserterOptions options;
  PlainGrid first(0.05);
  PlainGrid second(0.05);
  for (auto _ : state) {
    first.Insert(range_data, options.hit_probability, options.miss_probability);
    second.Insert(range_data, options.hit_probability, options.miss_probability);
  }
}
BENCHMARK(BM_PlainInsertScan)->Unit(benchmark::kMicrosecond);

/// 10,000 nodes, 20,000 INTRA and 15,000 INTER constraints; the start is off by decimetres.
const GraphProblem& LargeGraph() {
  static const GraphProblem graph = [] {
    const Recording recording = LargeRun::Make(10000, 15000);
    const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
    GraphProblem problem{
        state.global_from_submap, state.global_from_node, ConstraintsOf(recording, state), {}};
    Random random(3);
    const auto disturb = [&](Pose2* pose) {
      *pose = *pose * Pose2(random.Uniform(-0.2, 0.2), random.Uniform(-0.2, 0.2),
                            random.Uniform(-0.05, 0.05));
    };
    std::for_each(problem.global_from_submap.begin() + 1, problem.global_from_submap.end(),
                  [&](Pose2& pose) { disturb(&pose); });
    for (Pose2& pose : problem.global_from_node) disturb(&pose);
    return problem;
  }();
  return graph;
}

constexpr int kMaxNumIterations = 100;

void BM_SolveGraph(benchmark::State& state) {
  double cost = 0.0;
  for (auto _ : state) cost = SolveGraph(LargeGraph(), {}, {kMaxNumIterations}).final_cost;
  state.counters["cost"] = cost;
}
BENCHMARK(BM_SolveGraph)->Unit(benchmark::kMillisecond);

void BM_PlainSolveGraph(benchmark::State& state) {
  double cost = 0.0;
  for (auto _ : state) cost = SolveGraphWithCeres(LargeGraph(), {}, kMaxNumIterations).final_cost;
  state.counters["cost"] = cost;
}
BENCHMARK(BM_PlainSolveGraph)->Unit(benchmark::kMillisecond);

void BM_Simulate(benchmark::State& state) {
  const World world = MakeWorld("office");
  for (auto _ : state) benchmark::DoNotOptimize(Simulate(world, {}));
}
BENCHMARK(BM_Simulate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace loopscope
