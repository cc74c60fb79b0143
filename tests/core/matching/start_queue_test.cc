// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/start_queue.h"

#include <algorithm>
#include <tuple>
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
    const SearchBlock alone{{100, 100}, 9, 3, 4, 17};
    queue.Push(alone);
    expected.push_back(alone);
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

}  // namespace
}  // namespace loopscope
