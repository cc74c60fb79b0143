// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// A grid that no longer changes, in less than two bytes for each known cell: of cells in a row
/// with the same value, known or not, the value is kept once. Cells cannot be asked for.
class PackedGrid {
 public:
  explicit PackedGrid(const ProbabilityGrid& grid);

  /// The same grid again.
  ProbabilityGrid Unpack() const;

  std::size_t num_bytes() const { return words_.size() * sizeof(words_[0]); }

 private:
  double resolution_;
  CellBox box_;
  std::vector<std::uint16_t> words_;  ///< values, each of which may be followed by a count
};

}  // namespace loopscope
