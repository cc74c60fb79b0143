// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/blending.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/vector_targets.h"

namespace loopscope {
namespace {

std::uint8_t ByteUpTo(int max, Random* random) {
  return static_cast<std::uint8_t>(random->Below(max + 1));
}

/// A third each of clear, opaque and in between, in runs, as a picture has them.
std::vector<Color> RandomOver(std::size_t num_pixels, Random* random) {
  std::vector<Color> row;
  while (row.size() < num_pixels) {
    const int kind = random->Below(3);
    for (int run = random->Below(40); run >= 0 && row.size() < num_pixels; --run) {
      const std::uint8_t a = kind == 0 ? 0 : kind == 1 ? 255 : ByteUpTo(255, random);
      row.push_back({ByteUpTo(a, random), ByteUpTo(a, random), ByteUpTo(a, random), a});
    }
  }
  return row;
}

TEST(BlendRow, PutsWhatIsOverTheGroundInFrontOfItsRest) {
  Random random(1);
  for (const std::size_t num_pixels : {1, 3, 4, 8, 9, 31, 64, 1000}) {
    const std::vector<Color> over = RandomOver(num_pixels, &random);
    std::vector<Color> ground;
    std::vector<Color> expected;
    for (const Color& front : over) {
      ground.push_back({ByteUpTo(255, &random), ByteUpTo(255, &random), ByteUpTo(255, &random)});
      const Color& back = ground.back();
      const auto sum = [&](int in_front, int behind) {
        const double rest = behind * (255 - front.a) / 255.0;
        return static_cast<std::uint8_t>(in_front + std::lround(rest));
      };
      expected.push_back({sum(front.r, back.r), sum(front.g, back.g), sum(front.b, back.b)});
    }
    ForEachVectorTarget([&] {
      std::vector<Color> blended(num_pixels);
      BlendRow(over.data(), ground.data(), num_pixels, blended.data());
      EXPECT_EQ(blended, expected);
    });
  }
}

}  // namespace
}  // namespace loopscope
