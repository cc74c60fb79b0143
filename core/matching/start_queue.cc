// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/start_queue.h"

namespace loopscope {

SearchBlock SearchSquare::Best(int max_sum) const {
  int place = 0;  // of equals the first, which operator< has for the greatest
  while (sums[place] != max_sum || place % kBlocksPerSide >= num_columns) ++place;
  return BlockAt(place / kBlocksPerSide, place % kBlocksPerSide);
}

void StartQueue::Push(const SearchSquare& square, const SearchBlock& best) {
  entries_.push({best, static_cast<int>(squares_.size())});
  squares_.push_back(square);
}

SearchBlock StartQueue::Pop() {
  const Entry next = entries_.top();
  entries_.pop();
  if (next.square == kNoSquare) return next.block;
  SearchSquare& square = squares_[next.square];
  const int column = (next.block.offset.x - square.first.x) >> square.height;
  const int row = (next.block.offset.y - square.first.y) >> square.height;
  square.sums[row * kBlocksPerSide + column] = kTaken;
  const int max_sum = square.MaxSum();
  if (max_sum != kTaken) entries_.push({square.Best(max_sum), next.square});
  return next.block;
}

}  // namespace loopscope
