// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/block_sums.h"
#include "core/matching/search_block.h"

namespace loopscope {

/// 8 x 8 nodes of the tree side by side at one angle, or those of their first rows and columns.
struct SearchSquare {
  CellIndex first;
  int angle_index = 0;
  int height = 0;
  int num_rows = 0;
  int num_columns = 0;
  BlockSums sums;
  int first_trace_index = -1;    ///< of the first in a SearchTrace; the others follow, row-major
  std::uint64_t is_refined = 0;  ///< a bit for each, see StartQueue::RefineTop

  SearchBlock BlockAt(int row, int column) const {
    return {{first.x + (column << height), first.y + (row << height)},
            angle_index,
            height,
            sums[row * kBlocksPerSide + column],
            first_trace_index < 0 ? -1 : first_trace_index + row * num_columns + column};
  }

  int MaxSum() const { return MaxOfBlocks(sums.data(), num_rows, num_columns); }

  /// The greatest, of which `max_sum` is the sum.
  SearchBlock Best(int max_sum) const;
};

/// Start nodes (eq. 13), the greatest first. Squares give theirs one by one: most are never asked
/// for.
class StartQueue {
 public:
  StartQueue() {
    squares_.reserve(kUsualNumSquares);
    entries_.reserve(kUsualNumSquares);
  }

  bool empty() const { return entries_.empty(); }
  const SearchBlock& top() const { return entries_.front().block; }

  /// `best` is the best of the square.
  void Push(const SearchSquare& square, const SearchBlock& best);
  SearchBlock Pop();

  /// From a node down to those 4 x 4 that RefineTop takes it for.
  static constexpr int kHeightsDownToParts = 2;

  /// Whether RefineTop has nothing more to tell of the top.
  bool TopIsRefined() const;
  /// Where the 2 x 2 nodes of its square begin that the top is one of.
  CellIndex GroupOfTop() const;
  /// Lowers the bound of each node of this group to the highest bound of its parts: in its own each
  /// point may have its best cell in another part. `parts` are the 8 x 8 of all four nodes.
  void RefineTop(const BlockSums& parts);

 private:
  static constexpr int kUsualNumSquares = 32;  ///< of a window of a metre, one for each angle
  static constexpr int kTaken = -1;            ///< in place of the sum; less than any

  struct Entry {
    SearchBlock block;
    int square = 0;  ///< whose best it is

    friend bool operator<(const Entry& a, const Entry& b) { return a.block < b.block; }
  };

  /// Of a block of a square, row-major.
  static int PlaceOf(const SearchBlock& block, const SearchSquare& square);
  /// Instead of the top.
  void ReplaceByBest(int square);

  std::vector<SearchSquare> squares_;
  std::vector<Entry> entries_;  ///< a heap
};

}  // namespace loopscope
