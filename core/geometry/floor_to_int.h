// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace loopscope {

/// std::floor, which is a call of a function on plain x86-64.
inline int FloorToInt(double value) {
  const int truncated = static_cast<int>(value);
  return truncated - (value < truncated ? 1 : 0);
}

}  // namespace loopscope
