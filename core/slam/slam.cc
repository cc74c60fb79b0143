// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/slam.h"

#include <utility>

#include "core/local/scan_preparation.h"

namespace loopscope {
namespace {

Step ToStep(const LocalSlamResult& local) {
  Step step;
  step.local_from_base_prior = local.local_from_base_prior;
  step.local_from_base_correlative = local.local_from_base_correlative;
  step.local_from_base = local.local_from_base;
  step.match_start = local.match_start;
  step.wide_walls = local.wide_walls;
  step.outcome = local.insertion     ? StepOutcome::kInserted
                 : local.has_returns ? StepOutcome::kMotionFiltered
                                     : StepOutcome::kNoReturns;
  return step;
}

Optimization ToOptimization(int scan, bool final, GraphSolution solution,
                            const DriftShare& drift_share) {
  return {scan,
          final,
          std::move(solution.global_from_submap),
          std::move(solution.global_from_node),
          solution.num_iterations,
          solution.initial_cost,
          solution.final_cost,
          drift_share};
}

}  // namespace

Slam::Slam(const ScanLog& log, const Options& options, int num_threads)
    : log_(log),
      options_(options),
      local_slam_(log, options.trajectory_builder_2d),
      pose_graph_(options.pose_graph, num_threads) {}

SlamUpdate Slam::AddScan(int scan) {
  // Section IV of the paper: match the scan to the submap (CS), insert its hits and misses (2, 3).
  LocalSlamResult local = local_slam_.AddScan(scan);
  SlamUpdate update;
  update.step = ToStep(local);

  // Section V: each node and each finished submap set off loop searches (BBS) in the background.
  if (local.insertion) {
    AddNode(scan, local, &update);
    if (local.insertion->finished) {
      FinishSubmap(scan, std::move(*local.insertion->finished), &update);
    }
  }

  // Every few nodes the loops found enter the graph, and all poses are optimized (SPA, 4, 5).
  const bool is_last = scan + 1 == static_cast<int>(log_.scans.size());
  if (num_nodes_ > 0 && (is_last || pose_graph_.OptimizationIsDue())) {
    update.candidates = pose_graph_.CollectLoops(scan);
    update.optimization = is_last ? Finish(scan, &update) : Optimize(scan);
  }
  return update;
}

void Slam::AddNode(int scan, const LocalSlamResult& local, SlamUpdate* update) {
  const ActiveSubmaps::Insertion& insertion = *local.insertion;
  const NodeId id{num_nodes_++};
  if (insertion.started_local_from_submap) {
    update->started_submap = Submap{*insertion.started_local_from_submap, id, 0, -1};
    pose_graph_.AddSubmap(*insertion.started_local_from_submap);
  }
  update->step.node = id;
  update->node = Node{scan, local.local_from_base, insertion.first_submap, insertion.num_submaps};
  auto loop_scan =
      std::make_shared<const RangeData>(LoopScan(local.range_data, options_.trajectory_builder_2d));
  pose_graph_.AddNode(
      {local.local_from_base, local.odom_from_base, insertion.first_submap, insertion.num_submaps,
       std::move(loop_scan), MatchedNowhere(local.match_start)},
      scan);
}

void Slam::FinishSubmap(int scan, ActiveSubmap finished, SlamUpdate* update) {
  update->finished_submap = finished.id;
  pose_graph_.FinishSubmap(finished.id, finished.grid, scan);
}

Optimization Slam::Optimize(int scan) {
  GraphSolution solution = pose_graph_.Optimize();
  return ToOptimization(scan, false, std::move(solution), pose_graph_.drift_share());
}

Optimization Slam::Finish(int scan, SlamUpdate* update) {
  if (options_.pose_graph.constraint_builder.last_look.num_nodes == 0) {
    return ToOptimization(scan, true, pose_graph_.OptimizeAnew(), DriftShare{});
  }
  const GraphSolution first = pose_graph_.OptimizeFully();
  for (const LoopCandidate& candidate : pose_graph_.LookLast(scan)) {
    update->candidates.push_back(candidate);
  }
  return ToOptimization(scan, true, Continued(first, pose_graph_.OptimizeAnew()), DriftShare{});
}

}  // namespace loopscope
