// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/near_boxes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

Eigen::AlignedBox2d BoxAt(double x, double y) {
  return {Eigen::Vector2d(x, y), Eigen::Vector2d(x + 1.0, y + 1.0)};
}

TEST(NearBoxes, AreAtMostTheDistanceApart) {
  const std::vector<Eigen::AlignedBox2d> boxes = {BoxAt(3.0, 0.0), BoxAt(0.0, 0.0), BoxAt(3.0, 3.5),
                                                  BoxAt(0.5, 0.5)};
  const auto pairs = [&](double distance) { return NearBoxes(boxes, distance); };
  EXPECT_THAT(pairs(0.0), testing::ElementsAre(std::pair(3, 1)));
  EXPECT_THAT(pairs(1.5), testing::ElementsAre(std::pair(3, 0), std::pair(3, 1)));
  EXPECT_THAT(pairs(2.0), testing::ElementsAre(std::pair(1, 0), std::pair(3, 0), std::pair(3, 1)));
  EXPECT_EQ(pairs(9.0).size(), 6u);
}

TEST(NearBoxes, AreThoseOfABruteSearch) {
  Random random(11);
  for (int round = 0; round < 20; ++round) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (int i = 0; i < 60; ++i) {
      const Eigen::Vector2d corner(random.Uniform(-20.0, 20.0), random.Uniform(-20.0, 20.0));
      boxes.emplace_back(
          corner, corner + Eigen::Vector2d(random.Uniform(0.0, 9.0), random.Uniform(0.0, 3.0)));
    }
    std::vector<std::pair<int, int>> expected;
    for (int b = 0; b < 60; ++b) {
      for (int a = 0; a < b; ++a) {
        if (boxes[a].exteriorDistance(boxes[b]) <= 1.5) expected.emplace_back(b, a);
      }
    }
    EXPECT_EQ(NearBoxes(boxes, 1.5), expected);
  }
}

TEST(NearBoxes, AreNoneOfOneBox) {
  EXPECT_TRUE(NearBoxes({}, 1.0).empty());
  EXPECT_TRUE(NearBoxes({BoxAt(0.0, 0.0)}, 1.0).empty());
}

}  // namespace
}  // namespace loopscope
