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

/// Of the first `num_judged` constraints only those that are no outliers at the poses of the
/// problem, and all others.
GraphProblem WithoutKnownOutliers(const GraphProblem& problem, std::size_t num_judged,
                                  const OutlierOptions& options) {
  const auto is_outlier = [&](const Constraint& c) {
    return c.tag == Constraint::Tag::kInterSubmap &&
           IsOutlier(c, problem.global_from_submap, problem.global_from_node, options);
  };
  GraphProblem rest = problem;
  const auto judged_end = rest.constraints.begin() + static_cast<std::ptrdiff_t>(num_judged);
  rest.constraints.erase(std::remove_if(rest.constraints.begin(), judged_end, is_outlier),
                         judged_end);
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
  bool is_first = true;
  for (int round = 0; round < max_num_rounds; ++round) {
    all.global_from_submap = solution.global_from_submap;
    all.global_from_node = solution.global_from_node;
    GraphProblem rest = WithoutOutliers(all, options.outliers);
    if (HaveSamePairs(rest.constraints, solved)) break;
    solution = Continued(solution, SolveGraph(rest, options, limits));
    solved = std::move(rest.constraints);
    is_first = false;
  }
  if (is_first) return solution;
  all.global_from_submap = problem.global_from_submap;
  all.global_from_node = problem.global_from_node;
  all.constraints = std::move(solved);
  solution.initial_cost = CostOf(all, options);
  return solution;
}

}  // namespace loopscope
