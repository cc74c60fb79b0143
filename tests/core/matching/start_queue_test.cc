// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/start_queue.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

/// With few different sums, so that many are equal.
SearchSquare SomeSquare(int angle_index, Random* random) {
  SearchSquare square;
  square.first = {random->Below(50) - 25, random->Below(50) - 25};
  square.angle_index = angle_index;
  square.height = 3;
  square.num_rows = 1 + random->Below(kBlocksPerSide);
  square.num_columns = 1 + random->Below(kBlocksPerSide);
  for (auto& sum : square.sums) sum = random->Below(9);
  return square;
}

/// As they come out of the queue.
auto KeyOf(const SearchBlock& block) {
  return std::tuple(-block.sum, block.angle_index, block.offset.y, block.offset.x);
}

TEST(StartQueue, GivesAllStartNodesTheGreatestFirst) {
  Random random(6);
  for (int round = 0; round < 20; ++round) {
    StartQueue queue;
    std::vector<SearchBlock> expected;
    for (int angle = 0; angle < 5; ++angle) {
      const SearchSquare square = SomeSquare(angle, &random);
      queue.Push(square, square.Best(square.MaxSum()));
      for (int row = 0; row < square.num_rows; ++row) {
        for (int column = 0; column < square.num_columns; ++column) {
          expected.push_back({{square.first.x + 8 * column, square.first.y + 8 * row},
                              angle,
                              3,
                              square.sums[row * kBlocksPerSide + column],
                              -1});
        }
      }
    }
    std::sort(expected.begin(), expected.end(),
              [](const SearchBlock& a, const SearchBlock& b) { return KeyOf(a) < KeyOf(b); });
    for (const SearchBlock& block : expected) {
      ASSERT_FALSE(queue.empty());
      EXPECT_EQ(KeyOf(queue.top()), KeyOf(block));
      EXPECT_EQ(queue.top().trace_index, block.trace_index);
      EXPECT_EQ(KeyOf(queue.Pop()), KeyOf(block));
    }
    EXPECT_TRUE(queue.empty());
  }
}

/// The highest of the parts that make up the block of a group at `row` and `column`.
std::int32_t HighestOf(const BlockSums& parts, int row, int column) {
  std::int32_t highest = 0;
  for (int y = 4 * row; y < 4 * row + 4; ++y) {
    for (int x = 4 * column; x < 4 * column + 4; ++x) {
      highest = std::max(highest, parts[y * kBlocksPerSide + x]);
    }
  }
  return highest;
}

TEST(StartQueue, RefinesTheTopAndThoseBesideIt) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    StartQueue queue;
    std::map<std::pair<int, int>, SearchBlock> left;  // by row and column
    SearchSquare square = SomeSquare(0, &random);
    square.first_trace_index = 100;
    for (auto& sum : square.sums) sum = 100 + random.Below(100);
    queue.Push(square, square.Best(square.MaxSum()));
    for (int row = 0; row < square.num_rows; ++row) {
      for (int column = 0; column < square.num_columns; ++column) {
        left[{row, column}] = square.BlockAt(row, column);
      }
    }
    while (!left.empty()) {
      const auto best =
          std::max_element(left.begin(), left.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      ASSERT_EQ(KeyOf(queue.top()), KeyOf(best->second));
      ASSERT_EQ(queue.top().trace_index, best->second.trace_index);
      if (queue.TopIsRefined() || random.Below(2) == 0) {
        queue.Pop();
        left.erase(best);
        continue;
      }
      const auto [row, column] = best->first;
      const CellIndex group = queue.GroupOfTop();
      EXPECT_EQ(group,
                (CellIndex{square.first.x + 16 * (column / 2), square.first.y + 16 * (row / 2)}));
      BlockSums parts;
      for (auto& sum : parts) sum = random.Below(100);
      queue.RefineTop(parts);
      for (const int i : {0, 1}) {
        for (const int j : {0, 1}) {
          const auto beside = left.find({row / 2 * 2 + i, column / 2 * 2 + j});
          if (beside != left.end()) beside->second.sum = HighestOf(parts, i, j);
        }
      }
    }
    EXPECT_TRUE(queue.empty());
  }
}

}  // namespace
}  // namespace loopscope
