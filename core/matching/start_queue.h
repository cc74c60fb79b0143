// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <queue>
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

  SearchBlock BlockAt(int row, int column) const {
    return {{first.x + (column << height), first.y + (row << height)},
            angle_index,
            height,
            sums[row * kBlocksPerSide + column],
            -1};
  }

  int MaxSum() const { return MaxOfBlocks(sums, 0, num_rows, num_columns); }

  /// The greatest, of which `max_sum` is the sum.
  SearchBlock Best(int max_sum) const;
};

/// Start nodes (eq. 13), the greatest first. Squares give theirs one by one: most are never asked
/// for.
class StartQueue {
 public:
  StartQueue() { squares_.reserve(kUsualNumSquares); }

  bool empty() const { return entries_.empty(); }
  const SearchBlock& top() const { return entries_.top().block; }

  void Push(const SearchBlock& block) { entries_.push({block, kNoSquare}); }
  /// `best` is the best of the square.
  void Push(const SearchSquare& square, const SearchBlock& best);
  SearchBlock Pop();

 private:
  static constexpr int kUsualNumSquares = 32;  ///< of a window of a metre, one for each angle
  static constexpr int kNoSquare = -1;
  static constexpr int kTaken = -1;  ///< in place of the sum; less than any

  struct Entry {
    SearchBlock block;
    int square = kNoSquare;  ///< whose best it is

    friend bool operator<(const Entry& a, const Entry& b) { return a.block < b.block; }
  };

  std::vector<SearchSquare> squares_;
  std::priority_queue<Entry> entries_;
};

}  // namespace loopscope
