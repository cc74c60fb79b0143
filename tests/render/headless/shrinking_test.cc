// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/shrinking.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/vector_targets.h"

namespace loopscope {
namespace {

std::vector<std::uint8_t> RandomRow(std::size_t num_pixels, Random* random) {
  std::vector<std::uint8_t> row(kNumChannels * num_pixels);
  for (std::uint8_t& byte : row) byte = static_cast<std::uint8_t>(random->Below(256));
  return row;
}

/// With a byte behind it that must stay.
std::vector<std::uint8_t> RoomFor(std::size_t width) {
  return std::vector<std::uint8_t>(3 * width + 1, 77);
}

TEST(ShrinkRows, AveragesSquaresOfPixelsWhateverTheirNumber) {
  Random random(1);
  for (const std::size_t width : {1, 2, 7, 8, 33, 256, 300}) {
    const std::vector<std::uint8_t> lower = RandomRow(2 * width, &random);
    const std::vector<std::uint8_t> upper = RandomRow(2 * width, &random);
    std::vector<std::uint8_t> expected = RoomFor(width);
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::size_t left = kNumChannels * 2 * x + channel;
        const std::size_t right = left + kNumChannels;
        const int sum = lower[left] + lower[right] + upper[left] + upper[right];
        expected[3 * x + channel] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
    ForEachVectorTarget([&] {
      std::vector<std::uint8_t> rgb = RoomFor(width);
      ShrinkRows(lower.data(), upper.data(), width, rgb.data());
      EXPECT_EQ(rgb, expected);
    });
  }
}

TEST(DropAlpha, KeepsTheOtherChannels) {
  const std::uint8_t rgba[] = {1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<std::uint8_t> rgb = RoomFor(2);
  DropAlpha(rgba, 2, rgb.data());
  EXPECT_EQ(rgb, (std::vector<std::uint8_t>{1, 2, 3, 5, 6, 7, 77}));
}

}  // namespace
}  // namespace loopscope
