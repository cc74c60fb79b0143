// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace loopscope {

/// Calls `test` once for each set of instructions that the inner loops were compiled for and this
/// processor has.
template <typename Test>
void ForEachVectorTarget(const Test& test) {
  std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS;
  ASSERT_NE(rest, 0);
  for (; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::GetChosenTarget().Update(target);
    test();
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace loopscope
