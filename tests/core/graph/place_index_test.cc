// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/place_index.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

TEST(PlaceIndex, FindsAllWithinTheDistance) {
  Random random(3);
  PlaceIndex index;
  std::vector<Eigen::Vector2d> places;
  for (int id = 0; id < 500; ++id) {
    places.emplace_back(random.Uniform(-200.0, 200.0), random.Uniform(-80.0, 80.0));
    index.Add(id, places.back());
  }
  for (int round = 0; round < 100; ++round) {
    const Eigen::Vector2d center(random.Uniform(-220.0, 220.0), random.Uniform(-100.0, 100.0));
    const double distance = random.Uniform(0.0, 50.0);
    std::vector<int> within;
    for (const int id : index.Near(center, distance)) {
      const double farthest = distance + 10.0;  // the side of a bin
      EXPECT_LE((places[id] - center).lpNorm<Eigen::Infinity>(), farthest);
      if ((places[id] - center).norm() <= distance) within.push_back(id);
    }
    std::vector<int> expected;
    for (int id = 0; id < 500; ++id) {
      if ((places[id] - center).norm() <= distance) expected.push_back(id);
    }
    EXPECT_EQ(within, expected);
  }
}

TEST(PlaceIndex, IsAscendingWhateverTheOrderOfAdding) {
  PlaceIndex index;
  index.Add(4, {0.0, 0.0});
  index.Add(1, {30.0, 0.0});
  index.Add(3, {1.0, 0.0});
  EXPECT_EQ(index.Near({0.0, 0.0}, 40.0), (std::vector<int>{1, 3, 4}));
}

TEST(PlaceIndex, TakesAnyDistance) {
  PlaceIndex index;
  index.Add(0, {1e9, -1e9});
  index.Add(1, {-1e9, 1e9});
  EXPECT_EQ(index.Near({0.0, 0.0}, 1e12).size(), 2u);
  EXPECT_EQ(index.Near({0.0, 0.0}, std::numeric_limits<double>::infinity()).size(), 2u);
  EXPECT_TRUE(index.Near({0.0, 0.0}, 1.0).empty());
}

TEST(PlaceIndex, IsEmptyWhenCleared) {
  PlaceIndex index;
  index.Add(0, {0.0, 0.0});
  index.Clear();
  EXPECT_TRUE(index.Near({0.0, 0.0}, 1.0).empty());
}

}  // namespace
}  // namespace loopscope
