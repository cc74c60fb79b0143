// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/graph/graph_solver.h"

namespace loopscope {

/// SolveGraph by Ceres, with automatic derivatives and the order of elimination that it chooses.
GraphSolution SolveGraphWithCeres(const GraphProblem& problem,
                                  const OptimizationProblemOptions& options,
                                  int max_num_iterations);

}  // namespace loopscope
