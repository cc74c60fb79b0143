// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/slow_odometry.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

/// Odometry is at x[i] when scan i comes.
ScanLog LogOf(const std::vector<double>& x) {
  ScanLog log;
  for (const double at : x) {
    log.odometry.push_back({0.0, Pose2(at, 2.0, 0.001 * at)});
    log.scans.emplace_back();
    log.scans.back().num_odometry_before = static_cast<int>(log.odometry.size());
  }
  return log;
}

/// A robot that drives on by 1 m from scan to scan, of which odometry tells at every `period`-th.
std::vector<double> Driving(int num_scans, int period) {
  std::vector<double> x;
  for (int scan = 0; scan < num_scans; ++scan) x.push_back(scan - scan % period);
  return x;
}

void ExpectAt(double x, const std::optional<Pose2>& odom_from_base) {
  ASSERT_TRUE(odom_from_base);
  EXPECT_NEAR(odom_from_base->x(), x, 1e-12);
  EXPECT_EQ(odom_from_base->y(), 2.0);
  EXPECT_NEAR(odom_from_base->rotation, 0.001 * x, 1e-12);
}

TEST(SlowOdometry, IsSpreadOverTheScansSinceTheReadingBefore) {
  const ScanLog log = LogOf(Driving(100, 3));
  EXPECT_EQ(NumScansPerReading(log), 3);
  const OdometryOfScans odometry = ReadOdometryOfScans(log);
  ASSERT_EQ(odometry.size(), 100u);
  for (int scan = 0; scan < 100; ++scan) ExpectAt(scan, odometry[scan]);
}

TEST(SlowOdometry, LeavesARestAsItIs) {
  std::vector<double> x = Driving(90, 3);
  x.insert(x.begin() + 45, 20, x[44]);  // after the scan at which it told 42
  const OdometryOfScans odometry = ReadOdometryOfScans(LogOf(x));
  ExpectAt(42.0, odometry[60]);
  ExpectAt(42.0, odometry[62]);
  ExpectAt(43.0, odometry[63]);
  ExpectAt(45.0, odometry[65]);
}

TEST(SlowOdometry, LeavesLeapsAsTheyAre) {
  std::vector<double> x = Driving(90, 3);
  for (int scan = 60; scan < 90; ++scan) x[scan] += 1000.0;
  const OdometryOfScans odometry = ReadOdometryOfScans(LogOf(x));
  ExpectAt(57.0, odometry[59]);
  ExpectAt(1060.0, odometry[60]);
  ExpectAt(1061.0, odometry[61]);
}

TEST(SlowOdometry, IsNoneWhereTheRobotRestsNowAndThen) {
  std::vector<double> x = Driving(50, 1);
  for (int rest = 0; rest < 10; ++rest) x.insert(x.begin() + 5 * rest, 5, x[5 * rest]);
  const ScanLog log = LogOf(x);
  EXPECT_EQ(NumScansPerReading(log), 1);
  for (int scan = 0; scan < 100; ++scan) ExpectAt(x[scan], ReadOdometryOfScans(log)[scan]);
}

TEST(SlowOdometry, IsNotToldByAFewMotions) {
  EXPECT_EQ(NumScansPerReading(LogOf(Driving(60, 3))), 1);
}

TEST(SlowOdometry, IsNothingBeforeTheFirstReading) {
  ScanLog log = LogOf(Driving(100, 3));
  log.scans[0].num_odometry_before = 0;
  EXPECT_FALSE(ReadOdometryOfScans(log)[0]);
  EXPECT_TRUE(ReadOdometryOfScans({}).empty());
}

}  // namespace
}  // namespace loopscope
