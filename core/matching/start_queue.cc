// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/start_queue.h"

#include <algorithm>

namespace loopscope {
namespace {

constexpr int kPartsPerSide = 1 << StartQueue::kHeightsDownToParts;
static_assert(2 * kPartsPerSide == kBlocksPerSide, "a group has as many parts as a square blocks");

}  // namespace

SearchBlock SearchSquare::Best(int max_sum) const {
  int place = 0;  // of equals the first, which operator< has for the greatest
  while (sums[place] != max_sum || place % kBlocksPerSide >= num_columns) ++place;
  return BlockAt(place / kBlocksPerSide, place % kBlocksPerSide);
}

void StartQueue::Push(const SearchSquare& square, const SearchBlock& best) {
  entries_.push_back({best, static_cast<int>(squares_.size())});
  std::push_heap(entries_.begin(), entries_.end());
  squares_.push_back(square);
}

SearchBlock StartQueue::Pop() {
  const Entry next = entries_.front();
  SearchSquare& square = squares_[next.square];
  square.sums[PlaceOf(next.block, square)] = kTaken;
  ReplaceByBest(next.square);
  return next.block;
}

bool StartQueue::TopIsRefined() const {
  const SearchSquare& square = squares_[entries_.front().square];
  return (square.is_refined >> PlaceOf(top(), square) & 1) != 0;
}

CellIndex StartQueue::GroupOfTop() const {
  const SearchSquare& square = squares_[entries_.front().square];
  const int of_group = 2 << square.height;
  const CellIndex offset = top().offset;
  return {offset.x - (offset.x - square.first.x) % of_group,
          offset.y - (offset.y - square.first.y) % of_group};
}

void StartQueue::RefineTop(const BlockSums& parts) {
  const int index = entries_.front().square;
  SearchSquare& square = squares_[index];
  const int group = PlaceOf({GroupOfTop(), 0, 0, 0, 0}, square);
  for (const int in_group : {0, 1, kBlocksPerSide, kBlocksPerSide + 1}) {
    const int place = group + in_group;
    if (square.sums[place] == kTaken) continue;
    square.sums[place] =
        MaxOfBlocks(&parts[kPartsPerSide * in_group], kPartsPerSide, kPartsPerSide);
    square.is_refined |= std::uint64_t{1} << place;
  }
  ReplaceByBest(index);
}

int StartQueue::PlaceOf(const SearchBlock& block, const SearchSquare& square) {
  const int column = (block.offset.x - square.first.x) >> square.height;
  const int row = (block.offset.y - square.first.y) >> square.height;
  return row * kBlocksPerSide + column;
}

void StartQueue::ReplaceByBest(int square) {
  std::pop_heap(entries_.begin(), entries_.end());
  const int max_sum = squares_[square].MaxSum();
  if (max_sum == kTaken) {
    entries_.pop_back();
    return;
  }
  entries_.back() = {squares_[square].Best(max_sum), square};
  std::push_heap(entries_.begin(), entries_.end());
}

}  // namespace loopscope
