// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ray_caster.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

// The oracle: all segments are tried.
std::optional<double> NearestOfAll(const FloorPlan& plan, const Eigen::Vector2d& origin,
                                   double angle, double max_range) {
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  std::optional<double> nearest;
  for (const Segment& segment : plan.segments()) {
    const std::optional<double> distance = Intersect(origin, direction, segment);
    if (!distance || *distance > max_range) continue;
    nearest = std::min(nearest.value_or(*distance), *distance);
  }
  return nearest;
}

Eigen::Vector2d RandomPoint(Random& random) {
  return {random.Uniform(-8.0, 12.0), random.Uniform(-8.0, 12.0)};
}

FloorPlan RandomPlan(Random& random) {
  FloorPlan plan;
  plan.AddPolygon({{-8.0, -8.0}, {12.0, -8.0}, {12.0, 12.0}, {-8.0, 12.0}});
  for (int i = 0; i < 25; ++i) {
    const Eigen::Vector2d from = RandomPoint(random);
    plan.AddSegment(from, from + 0.3 * (RandomPoint(random) - from));
  }
  // Some on the lines between buckets, and some along an axis.
  plan.AddSegment({1.0, 1.0}, {1.0, 4.0});
  plan.AddSegment({-3.0, 2.5}, {-1.25, 2.5});
  return plan;
}

TEST(RayCaster, SeesWhatTryingAllSegmentsSees) {
  Random random(3);
  int num_seen = 0, num_unseen = 0;
  for (int world = 0; world < 20; ++world) {
    const FloorPlan plan = RandomPlan(random);
    const RayCaster ray_caster(plan);
    for (int ray = 0; ray < 500; ++ray) {
      const Eigen::Vector2d origin = RandomPoint(random);
      // Every fifth along an axis.
      const double angle =
          ray % 5 == 0 ? DegreesToRadians(90.0 * random.Below(4)) : random.Uniform(-4.0, 4.0);
      const auto expected = NearestOfAll(plan, origin, angle, 6.0);
      EXPECT_EQ(ray_caster.Distance(origin, angle, 6.0), expected) << world << " " << ray;
      ++(expected ? num_seen : num_unseen);
    }
  }
  EXPECT_GT(num_seen, 1000);
  EXPECT_GT(num_unseen, 1000);
}

TEST(RayCaster, SeesNothingInAnEmptyPlan) {
  EXPECT_EQ(RayCaster(FloorPlan()).Distance({0.2, 0.3}, 1.0, 100.0), std::nullopt);
}

TEST(RayCaster, SeesNothingFromOutside) {
  FloorPlan plan;
  plan.AddSegment({0.0, 0.0}, {0.0, 1.0});
  EXPECT_EQ(RayCaster(plan).Distance({-5.0, 0.5}, 0.0, 100.0), std::nullopt);
}

TEST(Intersect, GivesTheDistanceAlongTheRay) {
  const Segment segment{{2.0, -1.0}, {2.0, 1.0}};
  EXPECT_DOUBLE_EQ(*Intersect({0.0, 0.0}, {1.0, 0.0}, segment), 2.0);
  EXPECT_DOUBLE_EQ(*Intersect({0.0, 0.0}, {0.8, 0.4 * std::sqrt(0.8)}, segment), 2.5);
}

TEST(Intersect, LooksAheadOnly) {
  EXPECT_FALSE(Intersect({0.0, 0.0}, {-1.0, 0.0}, {{2.0, -1.0}, {2.0, 1.0}}));
}

TEST(Intersect, MissesBesideTheEndsAndAlongTheLine) {
  EXPECT_FALSE(Intersect({0.0, 1.01}, {1.0, 0.0}, {{2.0, -1.0}, {2.0, 1.0}}));
  EXPECT_FALSE(Intersect({2.0, -3.0}, {0.0, 1.0}, {{2.0, -1.0}, {2.0, 1.0}}));
}

}  // namespace
}  // namespace loopscope
