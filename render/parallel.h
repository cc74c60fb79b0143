// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace loopscope {

/// Calls `work` with 0 ... count - 1, several at a time, in no particular order. The first
/// exception of `work` is thrown once all have ended.
void ParallelFor(int count, const std::function<void(int)>& work);

}  // namespace loopscope
