// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/evaluation.h"
#include "render/views/error_view.h"

namespace loopscope {

/// What `loopscope evaluate --plot` draws: with a reference the absolute error at each of its
/// poses, else that of each relation, at its second pose. `run` has to outlive the result. Throws
/// std::invalid_argument if there is neither.
RunErrors RunErrorsOf(const EvaluatedRun& run, const Truth& truth);

}  // namespace loopscope
