// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/log_report.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// 100 scans of 100 beams, one every 0.1 s, 0.05 m apart: nothing is wrong with it.
ScanLog GoodLog() {
  ScanLog log;
  log.beam_geometries = {{100, -1.5, 0.03}};
  for (int i = 0; i < 100; ++i) {
    log.odometry.push_back({1e9 + 0.1 * i, Pose2(0.05 * i, 0.0, 0.0)});
    std::vector<float> ranges(100, 2.f);
    ranges[0] = 7.f;
    log.scans.push_back({1e9 + 0.1 * i, 0, ranges, i + 1});
  }
  return log;
}

TEST(LogReport, MeasuresALog) {
  ScanLog log = GoodLog();
  log.scans[0].ranges[1] = INFINITY;
  log.scans[0].ranges[2] = NAN;
  const LogReport report = ReportOn(log);
  EXPECT_NEAR(report.duration, 9.9, 1e-6);
  EXPECT_NEAR(report.scan_period, 0.1, 1e-6);
  EXPECT_NEAR(report.odometry_length, 4.95, 1e-6);
  EXPECT_NEAR(report.scan_distance, 0.05, 1e-6);
  EXPECT_NEAR(report.share_of_returns, 0.9998, 1e-9);
  EXPECT_NEAR(report.share_of_nothing, 0.0001, 1e-9);
  EXPECT_NEAR(report.share_of_invalid, 0.0001, 1e-9);
  EXPECT_EQ(report.median_range, 2.0);
  EXPECT_EQ(report.largest_range, 7.0);
}

TEST(LogReport, HasNoAdviceOnAGoodLog) { EXPECT_THAT(ReportOn(GoodLog()).advice, IsEmpty()); }

TEST(LogReport, TellsOfStampsThatRunBackwards) {
  ScanLog log = GoodLog();
  log.scans[50].time -= 0.9;
  EXPECT_THAT(ReportOn(log).advice, ElementsAre(HasSubstr("1 stamps of scans run backwards, by up "
                                                          "to 0.80 s")));
}

TEST(LogReport, TellsOfPauses) {
  ScanLog log = GoodLog();
  for (int i = 60; i < 100; ++i) log.scans[i].time += 20.0;
  const LogReport report = ReportOn(log);
  EXPECT_NEAR(report.longest_pause, 20.1, 1e-6);
  EXPECT_THAT(report.advice, ElementsAre(HasSubstr("No scan for 20.1 s before scan 60")));
}

TEST(LogReport, TellsOfAClockThatStandsStill) {
  ScanLog log = GoodLog();
  for (LaserScan& scan : log.scans) scan.time = 1e9;
  EXPECT_THAT(ReportOn(log).advice, ElementsAre(HasSubstr("All scans have the same stamp")));
}

TEST(LogReport, TellsOfMissingOdometry) {
  ScanLog log = GoodLog();
  log.odometry.clear();
  for (LaserScan& scan : log.scans) scan.num_odometry_before = 0;
  EXPECT_THAT(ReportOn(log).advice, ElementsAre(HasSubstr("No odometry")));
}

TEST(LogReport, TellsOfOdometryThatJumps) {
  ScanLog log = GoodLog();
  for (int i = 70; i < 100; ++i) log.odometry[i].odom_from_base.rotation = 1.5;
  EXPECT_THAT(ReportOn(log).advice,
              ElementsAre(HasSubstr("jumps 1 times, first by 0.05 m and 85.9 deg before scan 70")));
}

TEST(LogReport, TellsOfOdometryThatLeaps) {
  ScanLog log = GoodLog();
  for (int i = 70; i < 100; ++i) log.odometry[i].odom_from_base.translation.y() = 101.0;
  const LogReport report = ReportOn(log);
  EXPECT_THAT(
      report.advice,
      ElementsAre(HasSubstr("leaps by 100 m or more before 1 scans, first before scan 70")));
  EXPECT_LT(report.odometry_length, 50.0);
}

TEST(LogReport, TellsOfOdometryThatHangs) {
  ScanLog log = GoodLog();
  for (int i = 70; i < 73; ++i) {
    log.scans[i].num_odometry_before = log.scans[69].num_odometry_before;
    for (float& range : log.scans[i].ranges) range += 0.5F * static_cast<float>(i - 69);
  }
  EXPECT_THAT(ReportOn(log).advice,
              ElementsAre(HasSubstr("stands still before 3 scans, first before scan 70")));
}

TEST(LogReport, TellsOfOdometryThatIsSlowerThanTheScans) {
  ScanLog log = GoodLog();
  for (int i = 0; i < 100; ++i)
    log.odometry[i].odom_from_base = Pose2(0.05 * (i - i % 3), 0.0, 0.0);
  EXPECT_THAT(ReportOn(log).advice, ElementsAre(HasSubstr("Odometry is new at one scan in 3")));
}

TEST(LogReport, TellsOfKeyFrames) {
  ScanLog log = GoodLog();
  for (int i = 0; i < 100; ++i) log.odometry[i].odom_from_base.translation.x() = 0.9 * i;
  for (int i = 0; i < 100; ++i) log.odometry[i].time = log.scans[i].time = 1e9 + i;
  EXPECT_THAT(ReportOn(log).advice, ElementsAre(HasSubstr("Scans are 0.9 m apart")));
}

TEST(LogReport, TellsOfReadingsThatSayLittle) {
  ScanLog log = GoodLog();
  log.beam_geometries[0].num_beams = 50;
  for (LaserScan& scan : log.scans) {
    scan.ranges.resize(50);
    for (int i = 0; i < 30; ++i) scan.ranges[i] = INFINITY;
    for (int i = 30; i < 35; ++i) scan.ranges[i] = NAN;
  }
  EXPECT_THAT(ReportOn(log).advice,
              ElementsAre(HasSubstr("From 60 % of the beams nothing came back"),
                          HasSubstr("10 % of the readings are invalid"),
                          HasSubstr("Scans of less than 60 beams")));
}

TEST(LogReport, OfNoScansIsEmpty) { EXPECT_THAT(ReportOn(ScanLog()).advice, IsEmpty()); }

}  // namespace
}  // namespace loopscope
