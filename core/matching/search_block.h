// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "core/grid/cell.h"

namespace loopscope {

/// A node c of eqs. 11 and 12 with its bound.
struct SearchBlock {
  CellIndex offset;
  int angle_index = 0;
  int height = 0;
  int sum = 0;           ///< of 8-bit values, the bound of eq. 16
  int trace_index = -1;  ///< in a SearchTrace

  /// Of nodes of one height: the first to be branched is the greatest.
  friend bool operator<(const SearchBlock& a, const SearchBlock& b) {
    return std::tuple(a.sum, -a.angle_index, -a.offset.y, -a.offset.x) <
           std::tuple(b.sum, -b.angle_index, -b.offset.y, -b.offset.x);
  }
};

}  // namespace loopscope
