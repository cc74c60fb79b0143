// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/evaluation.h"

namespace loopscope {

// What `loopscope evaluate` prints.

/// A line a run; of a single run also the statistics behind it.
std::string EvaluationTable(const std::vector<Evaluation>& evaluations);

/// False and missed loops of each run, a line each.
std::string LoopLists(const std::vector<Evaluation>& evaluations);

/// Every figure; a run has empty fields for what does not apply to it.
std::string EvaluationCsv(const std::vector<Evaluation>& evaluations);

/// Every figure that applies; `with_loops` also false and missed loops.
std::string EvaluationJson(const std::vector<Evaluation>& evaluations, bool with_loops);

}  // namespace loopscope
