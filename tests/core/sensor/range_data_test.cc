// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/range_data.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const BeamGeometry kFourBeams{4, -M_PI / 2.0, M_PI / 2.0};  // right, ahead, left, behind

RangeData FromRanges(const std::vector<float>& ranges, const RangeOptions& options,
                     const Pose2& base_from_laser = Pose2()) {
  LaserScan scan;
  scan.ranges = ranges;
  return ToRangeData(scan, kFourBeams, base_from_laser, options);
}

void ExpectPoints(const PointCloud& points, const PointCloud& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR((points[i] - expected[i]).norm(), 0.0, 1e-12)
        << "point " << i << " is " << points[i].transpose();
  }
}

TEST(ToRangeData, PutsReturnsInTheDirectionsOfTheirBeams) {
  const RangeData data = FromRanges({1.0f, 2.0f, 3.0f, 4.0f}, RangeOptions());
  ExpectPoints(data.returns, {{0.0, -1.0}, {2.0, 0.0}, {0.0, 3.0}, {-4.0, 0.0}});
  EXPECT_TRUE(data.misses.empty());
}

TEST(ToRangeData, MovesAllToTheFrameOfTheRobot) {
  const Pose2 base_from_laser(0.5, 0.25, M_PI / 2.0);  // looks to the left
  const RangeData data = FromRanges({1.0f, 2.0f, 50.0f, 4.0f}, RangeOptions(), base_from_laser);
  ExpectPoints({data.origin}, {{0.5, 0.25}});
  ExpectPoints(data.returns, {{1.5, 0.25}, {0.5, 2.25}, {0.5, -3.75}});
  ExpectPoints(data.misses, {{-4.5, 0.25}});
}

TEST(ToRangeData, GivesNothingForReadingsThatAreNoDistance) {
  const RangeData data = FromRanges({kNan, kInfinity, -1.0f, 0.0f}, RangeOptions());
  EXPECT_TRUE(data.returns.empty());
  EXPECT_TRUE(data.misses.empty());
}

TEST(ToRangeData, DropsReadingsNearerThanTheMinimum) {
  const RangeData data = FromRanges({0.49f, 0.5f, 0.51f, 9.0f}, {0.5, 8.0, 5.0});
  ExpectPoints(data.returns, {{0.5, 0.0}, {0.0, 0.51f}});
}

TEST(ToRangeData, CutsReadingsBeyondTheMaximumToMisses) {
  const RangeData data = FromRanges({7.9f, 8.0f, 8.1f, 81.0f}, {0.5, 8.0, 5.0});
  ExpectPoints(data.returns, {{0.0, -7.9f}, {8.0, 0.0}});
  ExpectPoints(data.misses, {{0.0, 5.0}, {-5.0, 0.0}});
}

TEST(Transform, MovesTheOriginAndEveryPoint) {
  const RangeData data{{1.0, 0.0}, {{2.0, 0.0}, {0.0, 1.0}}, {{3.0, 1.0}}};
  const RangeData moved = Transform(Pose2(10.0, 20.0, M_PI / 2.0), data);
  ExpectPoints({moved.origin}, {{10.0, 21.0}});
  ExpectPoints(moved.returns, {{10.0, 22.0}, {9.0, 20.0}});
  ExpectPoints(moved.misses, {{9.0, 23.0}});
}

}  // namespace
}  // namespace loopscope
