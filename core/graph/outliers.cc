// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/outliers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

bool HaveSamePairs(const std::vector<Constraint>& a, const std::vector<Constraint>& b) {
  const auto is_same = [](const Constraint& x, const Constraint& y) {
    return x.submap == y.submap && x.node == y.node && x.tag == y.tag;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same);
}

/// Takes those that are outliers at these poses out of the first `num_judged`.
void RemoveOutliers(std::size_t num_judged, const std::vector<Pose2>& global_from_submap,
                    const std::vector<Pose2>& global_from_node, const OutlierOptions& options,
                    std::vector<Constraint>* constraints) {
  const auto is_outlier = [&](const Constraint& c) {
    return c.tag == Constraint::Tag::kInterSubmap &&
           IsOutlier(c, global_from_submap, global_from_node, options);
  };
  const auto judged_end = constraints->begin() + static_cast<std::ptrdiff_t>(num_judged);
  constraints->erase(std::remove_if(constraints->begin(), judged_end, is_outlier), judged_end);
}

/// Of the first `num_judged` constraints only those that are no outliers at the poses of the
/// problem, and all others.
GraphProblem WithoutKnownOutliers(const GraphProblem& problem, std::size_t num_judged,
                                  const OutlierOptions& options) {
  GraphProblem rest = problem;
  RemoveOutliers(num_judged, problem.global_from_submap, problem.global_from_node, options,
                 &rest.constraints);
  return rest;
}

}  // namespace

bool IsOutlier(const Eigen::Vector3d& residual, const OutlierOptions& options) {
  return options.max_distance > 0.0 && (residual.head<2>().norm() > options.max_distance ||
                                        std::abs(residual.z()) > options.max_angle);
}

bool IsOutlier(const Constraint& loop, const std::vector<Pose2>& global_from_submap,
               const std::vector<Pose2>& global_from_node, const OutlierOptions& options) {
  return IsOutlier(SpaError(loop.submap_from_node, global_from_submap[loop.submap.index],
                            global_from_node[loop.node.index]),
                   options);
}

std::vector<Constraint> WithoutOutliers(std::vector<Constraint> constraints,
                                        const std::vector<Pose2>& global_from_submap,
                                        const std::vector<Pose2>& global_from_node,
                                        const OutlierOptions& options) {
  RemoveOutliers(constraints.size(), global_from_submap, global_from_node, options, &constraints);
  return constraints;
}

GraphProblem WithoutOutliers(const GraphProblem& problem, const OutlierOptions& options) {
  return WithoutKnownOutliers(problem, problem.constraints.size(), options);
}

GraphSolution SolveGraphWithoutOutliers(const GraphProblem& problem, std::size_t num_judged,
                                        const OptimizationProblemOptions& options,
                                        const SolverLimits& limits, int max_num_rounds) {
  const GraphProblem first = WithoutKnownOutliers(problem, num_judged, options.outliers);
  GraphSolution solution = SolveGraph(first, options, limits);
  std::vector<Constraint> solved = first.constraints;
  GraphProblem all = problem;
  int round = 0;
  for (; round < max_num_rounds; ++round) {
    all.global_from_submap = solution.global_from_submap;
    all.global_from_node = solution.global_from_node;
    GraphProblem rest = WithoutOutliers(all, options.outliers);
    if (HaveSamePairs(rest.constraints, solved)) break;
    solution = Continued(solution, SolveGraph(rest, options, limits));
    solved = std::move(rest.constraints);
  }
  if (round == 0) return solution;
  all.global_from_submap = problem.global_from_submap;
  all.global_from_node = problem.global_from_node;
  all.constraints = std::move(solved);
  solution.initial_cost = CostOf(all, options);
  return solution;
}

}  // namespace loopscope
