// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_log.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A FLASER line of two readings.
std::string Flaser(const std::string& readings, const std::string& x, const std::string& stamps) {
  return "FLASER 2 " + readings + " " + x + " 0 0 " + x + " 0 0 " + stamps + "\n";
}

std::string Odom(const std::string& x, const std::string& stamps) {
  return "ODOM " + x + " 0 0 0 0 0 " + stamps + "\n";
}

ScanLog Read(const std::string& content) {
  const TemporaryFolder folder;
  return ReadCarmenLog(folder.Write("some.log", content));
}

/// How often the log's notes say `what`.
int CountOf(const ScanLog& log, const std::string& what) {
  for (const LogNote& note : log.notes) {
    if (note.what == what) return note.count;
  }
  return 0;
}

std::vector<double> TimesOfScans(const ScanLog& log) {
  std::vector<double> times;
  for (const LaserScan& scan : log.scans) times.push_back(scan.time);
  return times;
}

std::vector<double> TimesOfOdometry(const ScanLog& log) {
  std::vector<double> times;
  for (const OdometryReading& reading : log.odometry) times.push_back(reading.time);
  return times;
}

TEST(CarmenLog, TakesScansInTheOrderOfTheFile) {
  const ScanLog log = Read("# a comment\r\n" + Flaser("1.5 2", "0", "10.5 host 0.5") + "\r\n" +
                           Flaser("3 4", "1", "10.25 host 0.75"));
  EXPECT_EQ(log.name, "some.log");
  EXPECT_THAT(TimesOfScans(log), ElementsAre(10.5, 10.25));
  EXPECT_THAT(log.scans[0].ranges, ElementsAre(1.5f, 2.f));
  EXPECT_EQ(CountOf(log, "scan stamps that run backwards"), 1);
  ASSERT_EQ(log.beam_geometries.size(), 1u);
  EXPECT_EQ(log.beam_geometries[0].num_beams, 2);
}

TEST(CarmenLog, ThePoseInAScanIsAnOdometryReadingBeforeIt) {
  const ScanLog log = Read(Odom("0", "10 h 0") + Flaser("1 2", "0.5", "11 h 1") +
                           Odom("1", "12 h 2") + Flaser("1 2", "1.5", "13 h 3"));
  EXPECT_THAT(TimesOfOdometry(log), ElementsAre(10, 11, 12, 13));
  EXPECT_EQ(log.scans[0].num_odometry_before, 2);
  EXPECT_EQ(log.scans[1].num_odometry_before, 4);
  EXPECT_EQ(OdometryOfScan(log, 1)->odom_from_base, Pose2(1.5, 0.0, 0.0));
}

TEST(CarmenLog, APoseThatRepeatsTheOdometryBeforeItIsNotTakenTwice) {
  const ScanLog log =
      Read(Odom("0", "10 h 0") + Odom("1", "11 h 1") + Flaser("1 2", "1", "11 h 1"));
  EXPECT_THAT(TimesOfOdometry(log), ElementsAre(10, 11));
  EXPECT_EQ(log.scans[0].num_odometry_before, 2);
}

TEST(CarmenLog, OdometryThatNeverMovesIsNone) {
  const ScanLog log = Read(Flaser("1 2", "0", "10 h 0") + Flaser("1 2", "0", "11 h 1"));
  EXPECT_THAT(log.odometry, IsEmpty());
  EXPECT_EQ(log.scans[1].num_odometry_before, 0);
  EXPECT_EQ(CountOf(log, "odometry poses that never change, dropped"), 2);
}

TEST(CarmenLog, NothingCameBackIsInfinityAndNonsenseIsNaN) {
  const ScanLog log = Read("FLASER 8 1.5 81.91 81.83 51.11 50.0 32.77 0 -1 0 0 0 0 0 0 10 h 0\n");
  const std::vector<float>& ranges = log.scans[0].ranges;
  EXPECT_EQ(ranges[0], 1.5f);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(ranges[i], INFINITY) << i;
  EXPECT_TRUE(std::isnan(ranges[6]));
  EXPECT_TRUE(std::isnan(ranges[7]));
  EXPECT_EQ(CountOf(log, "readings that mean that nothing came back"), 5);
  EXPECT_EQ(CountOf(log, "readings that are no number or not above zero"), 2);
}

TEST(CarmenLog, AnnouncedRangesBoundTheReadings) {
  const ScanLog by_parameter =
      Read("PARAM robot_front_laser_max 20 1 h 1\n" + Flaser("19.99 20.0", "0", "10 h 0"));
  EXPECT_THAT(by_parameter.scans[0].ranges, ElementsAre(19.99f, INFINITY));
  const ScanLog by_line = Read("RAWLASER1 0 -1 2 2 30 0.01 0 2 29.5 30 0 10 h 0\n");
  EXPECT_THAT(by_line.scans[0].ranges, ElementsAre(29.5f, INFINITY));
}

TEST(CarmenLog, AnUnknownCodeIsKnownByItsPile) {
  std::string text;
  for (int i = 0; i < 200; ++i) {
    text += Flaser(std::to_string(1 + i % 10) + ".5 79.99", "0", std::to_string(10 + i) + " h 1");
  }
  const ScanLog log = Read(text);
  EXPECT_THAT(log.scans[7].ranges, ElementsAre(8.5f, INFINITY));
  EXPECT_EQ(CountOf(log, "readings of 79.99 m, the largest and too frequent: no return"), 200);
}

TEST(CarmenLog, AFewReadingsOfTheLargestRangeAreReturns) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += Flaser("1.5 25.5", "0", std::to_string(10 + i) + " h 1");
  EXPECT_THAT(Read(text).scans[7].ranges, ElementsAre(1.5f, 25.5f));
}

TEST(CarmenLog, ALogInCentimetresIsConverted) {
  const ScanLog log = Read("FLASER 4 150 8191 8183 225 0 0 0 0 0 0 10 h 0\n");
  EXPECT_THAT(log.scans[0].ranges, ElementsAre(1.5f, INFINITY, INFINITY, 2.25f));
}

TEST(CarmenLog, ACentimetreCodeAmongMetresConvertsNothing) {
  const ScanLog log = Read("FLASER 4 1.5 8191 3 2.25 0 0 0 0 0 0 10 h 0\n");
  EXPECT_THAT(log.scans[0].ranges, ElementsAre(1.5f, INFINITY, 3.f, 2.25f));
}

TEST(CarmenLog, TheScannerStandsWhereTheParametersSay) {
  const std::string scan = Flaser("1 2", "0", "10 h 0");
  EXPECT_EQ(Read("PARAM robot_frontlaser_offset -0.04 1 h 1\n" + scan).base_from_laser,
            Pose2(-0.04, 0.0, 0.0));
  EXPECT_EQ(Read(scan + "PARAM robot_frontlaser_offset 0.2 1 h 1\n").base_from_laser,
            Pose2(0.2, 0.0, 0.0));
  EXPECT_EQ(Read(scan).base_from_laser, Pose2());
}

TEST(CarmenLog, PosesOfTheLaserApartFromTheRobotsSayWhereItStands) {
  const ScanLog log = Read(
      "PARAM robot_frontlaser_offset 0.1 1 h 1\n"
      "FLASER 1 1 0.3 0 0 0 0 0 10 h 0\n"
      "FLASER 1 1 5 1.3 1.5707963 5 1 1.5707963 11 h 1\n");
  EXPECT_NEAR(log.base_from_laser.x(), 0.3, 1e-6);
  EXPECT_NEAR(log.base_from_laser.y(), 0.0, 1e-6);
}

TEST(CarmenLog, CorrectedPosesOfTheLaserSayNothingAboutItsPlace) {
  const ScanLog log = Read(
      "PARAM robot_frontlaser_offset 0.1 1 h 1\n"
      "FLASER 1 1 0.3 0 0 0 0 0 10 h 0\n"
      "FLASER 1 1 2.3 0 0 1 0 0 11 h 1\n");
  EXPECT_EQ(log.base_from_laser, Pose2(0.1, 0.0, 0.0));
}

TEST(CarmenLog, ScansOfOneKindAreTaken) {
  const std::string raw = "RAWLASER1 0 -1 2 2 30 0.01 0 2 7 8 0 10 h 0\n";
  const std::string rear = "RLASER 2 5 6 0 0 0 0 0 0 10 h 0\n";
  const ScanLog log = Read(raw + rear + Flaser("1 2", "0", "10 h 0"));
  ASSERT_EQ(log.scans.size(), 1u);
  EXPECT_THAT(log.scans[0].ranges, ElementsAre(1.f, 2.f));
  EXPECT_EQ(CountOf(log, "RAWLASER1 lines, not used: FLASER taken"), 1);
  EXPECT_EQ(CountOf(log, "RLASER lines, not used: FLASER taken"), 1);
}

TEST(CarmenLog, TheRearScannerLooksBack) {
  const ScanLog log = Read(
      "PARAM robot_rearlaser_offset -0.3 1 h 1\n"
      "RLASER 2 5 6 0 0 0 0 0 0 10 h 0\n");
  EXPECT_EQ(log.base_from_laser, Pose2(-0.3, 0.0, M_PI));
}

TEST(CarmenLog, RobotLaserGivesScansAndOdometry) {
  const std::string geometry = "ROBOTLASER1 0 -1 2 2 30 0.01 0 2 1 2 0 ";
  const ScanLog log = Read(geometry + "0.2 0 0 0 0 0 0 0 0.1 0.2 1e6 10 h 0\n" + geometry +
                           "1.2 0 0 1 0 0 0 0 0.1 0.2 1e6 11 h 1\n");
  EXPECT_EQ(log.scans.size(), 2u);
  EXPECT_THAT(TimesOfOdometry(log), ElementsAre(10, 11));
  EXPECT_NEAR(log.base_from_laser.x(), 0.2, 1e-12);
  EXPECT_EQ(log.beam_geometries[0], (BeamGeometry{2, -1.0, 2.0}));
}

TEST(CarmenLog, ScansWithOtherNumbersOfBeamsGetAGeometryOfTheirOwn) {
  const ScanLog log = Read("FLASER 1 1 0 0 0 0 0 0 10 h 0\n" + Flaser("1 2", "1", "11 h 1") +
                           "FLASER 1 1 2 0 0 2 0 0 12 h 2\n");
  EXPECT_EQ(log.scans[0].beam_geometry, 0);
  EXPECT_EQ(log.scans[1].beam_geometry, 1);
  EXPECT_EQ(log.scans[2].beam_geometry, 0);
}

TEST(CarmenLog, TheLoggersClockFillsInMovedToTheMessagesClock) {
  const ScanLog log = Read(Flaser("1 2", "0", "1000000.5 h 0.5") + Flaser("1 2", "1", "0 h 1.5") +
                           Flaser("1 2", "2", "1000002.5 h 2.5"));
  EXPECT_THAT(TimesOfScans(log), ElementsAre(1000000.5, 1000001.5, 1000002.5));
  EXPECT_EQ(CountOf(log, "stamps taken from the logger's clock"), 1);
}

TEST(CarmenLog, TheLoggersClockIsTakenWhereTheMessagesStandsStill) {
  const ScanLog log =
      Read(Flaser("1 2", "0", "1.13486e+09 h 0.5") + Flaser("1 2", "1", "1.13486e+09 h 0.75") +
           Flaser("1 2", "2", "1.13486e+09 h 1.0"));
  EXPECT_THAT(TimesOfScans(log), ElementsAre(0.5, 0.75, 1.0));
}

TEST(CarmenLog, EchoesWithoutTimeAreSkipped) {
  const ScanLog log = Read(Odom("9", "0 h 0") + Flaser("1 2", "0", "1134864629.5 h 1134864629.6") +
                           Odom("9", "0 h 0") + Flaser("1 2", "1", "1134864630.5 h 1134864630.6"));
  EXPECT_THAT(TimesOfOdometry(log), ElementsAre(1134864629.5, 1134864630.5));
  EXPECT_EQ(CountOf(log, "lines whose time is zero, skipped"), 2);
}

TEST(CarmenLog, ALogMayBeginAtZero) {
  const ScanLog log = Read(Odom("0", "0 h 0") + Flaser("1 2", "0.5", "0.45 h 0.45") +
                           Odom("0.75", "0 h 0") + Odom("1", "0.9 h 0.9"));
  EXPECT_THAT(TimesOfOdometry(log), ElementsAre(0, 0.45, 0.9));
}

TEST(CarmenLog, BadLinesInTheMiddleAreSkippedAndTold) {
  const ScanLog log = Read(Flaser("1 2", "0", "10 h 0") + "FLASER 1000000000 1 2 0 0 0 0\n" +
                           "NEFF 12.5\n" + "\x01\x02garbage\n" + "ODOM nan 0 0 0 0 0 10 h 0\n" +
                           "FLASER 3 1 2 0 0 0 0 0 0 10 h 0\n" + Flaser("1 2", "1", "11 h 1"));
  EXPECT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(CountOf(log, "scan lines with a wrong count of readings, skipped"), 1);
  EXPECT_EQ(CountOf(log, "scan lines without readable pose and time, skipped"), 1);
  EXPECT_EQ(CountOf(log, "ODOM lines without readable pose and time, skipped"), 1);
  EXPECT_EQ(CountOf(log, "NEFF lines, not used"), 1);
  EXPECT_EQ(CountOf(log, "lines of unknown kind, skipped"), 1);
}

TEST(CarmenLog, NotesTellTheFirstLine) {
  const ScanLog log =
      Read("# head\n" + Flaser("1 0", "0", "10 h 0") + Flaser("0 2", "1", "11 h 1"));
  for (const LogNote& note : log.notes) {
    if (note.what == "readings that are no number or not above zero") {
      EXPECT_EQ(note.first_line, 2);
      EXPECT_EQ(note.count, 2);
      return;
    }
  }
  FAIL() << "no such note";
}

TEST(CarmenLog, ALastLineThatBreaksOffIsSkipped) {
  const std::string first = Flaser("1 2", "0", "10 h 0");
  const ScanLog log = Read(first + "FLASER 2 1 2 1 0 0 1 0 0 11");
  EXPECT_EQ(log.scans.size(), 1u);
  EXPECT_EQ(CountOf(log, "last line breaks off, skipped"), 1);
  EXPECT_EQ(Read(first + "FLASER 2 1 2 1 0 0 1 0 0 11 h 1").scans.size(), 2u);
}

TEST(CarmenLog, ALineOfSeveralMegabytesIsSkipped) {
  std::string huge = "FLASER 2000000";
  for (int i = 0; i < 2000000; ++i) huge += " 1";
  const ScanLog log = Read(huge + " 0 0 0 0 0 0 10 h 0\n" + Flaser("1 2", "0", "10 h 0"));
  EXPECT_EQ(log.scans.size(), 1u);
  EXPECT_EQ(CountOf(log, "lines of more than 1048576 bytes, skipped"), 1);
}

TEST(CarmenLog, AFileWithoutScansThrowsOneLine) {
  for (const std::string& content : {std::string(), std::string("\0\x1f\x8b\xff\n\n", 6),
                                     Odom("1", "10 h 0"), std::string("PARAM a b 1 h 1\n")}) {
    const std::string message = MessageOf([&] { Read(content); });
    EXPECT_THAT(message, HasSubstr("some.log: no scan; expected a CARMEN log"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(CarmenLog, AFileWhoseScansAreAllBadThrowsWithTheFirst) {
  EXPECT_THAT(MessageOf([] { Read("# head\nFLASER 3 1 2 3\nFLASER 3 1 2 3\n"); }),
              HasSubstr("some.log:2: no scan can be read: scan lines with a wrong count"));
}

}  // namespace
}  // namespace loopscope
