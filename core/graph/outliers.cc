// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/outliers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

/// Loops near the bound could come and go for ever.
constexpr int kMaxRounds = 10;

bool HaveSamePairs(const std::vector<Constraint>& a, const std::vector<Constraint>& b) {
  const auto is_same = [](const Constraint& x, const Constraint& y) {
    return x.submap == y.submap && x.node == y.node && x.tag == y.tag;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same);
}

}  // namespace

bool IsOutlier(const Eigen::Vector3d& residual, const OutlierOptions& options) {
  return options.max_distance > 0.0 && (residual.head<2>().norm() > options.max_distance ||
                                        std::abs(residual.z()) > options.max_angle);
}

GraphProblem WithoutOutliers(const GraphProblem& problem, const OutlierOptions& options) {
  const auto is_outlier = [&](const Constraint& c) {
    const Eigen::Vector3d residual =
        SpaError(c.submap_from_node, problem.global_from_submap[c.submap.index],
                 problem.global_from_node[c.node.index]);
    return c.tag == Constraint::Tag::kInterSubmap && IsOutlier(residual, options);
  };
  GraphProblem rest = problem;
  rest.constraints.erase(
      std::remove_if(rest.constraints.begin(), rest.constraints.end(), is_outlier),
      rest.constraints.end());
  return rest;
}

GraphSolution SolveGraphWithoutOutliers(const GraphProblem& problem,
                                        const OptimizationProblemOptions& options,
                                        int max_num_iterations) {
  GraphSolution solution = SolveGraph(problem, options, max_num_iterations);
  std::vector<Constraint> solved = problem.constraints;
  GraphProblem all = problem;
  for (int round = 0; round < kMaxRounds; ++round) {
    all.global_from_submap = solution.global_from_submap;
    all.global_from_node = solution.global_from_node;
    GraphProblem rest = WithoutOutliers(all, options.outliers);
    if (HaveSamePairs(rest.constraints, solved)) break;
    solution = Continued(solution, SolveGraph(rest, options, max_num_iterations));
    solved = std::move(rest.constraints);
  }
  return solution;
}

}  // namespace loopscope
