// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_line.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/words.h"

namespace loopscope {
namespace {

using testing::ElementsAre;

CarmenParse Parse(const std::string& line, bool cut_off = false) {
  std::vector<std::string_view> words;
  SplitWords(line, &words);
  return words.front() == "ODOM" ? ParseCarmenOdometry(words, cut_off)
                                 : ParseCarmenScan(words, cut_off);
}

CarmenRecord RecordOf(const std::string& line) { return std::get<CarmenRecord>(Parse(line)); }

std::string FaultOf(const std::string& line, bool cut_off = false) {
  const CarmenParse parse = Parse(line, cut_off);
  const auto* const fault = std::get_if<std::string>(&parse);
  return fault == nullptr ? "" : *fault;
}

constexpr char kWrongCount[] = "scan lines with a wrong count of readings, skipped";
constexpr char kBadScan[] = "scan lines without readable pose and time, skipped";
constexpr char kBadOdometry[] = "ODOM lines without readable pose and time, skipped";

TEST(CarmenLine, OdometryHasPoseAndBothStamps) {
  const CarmenRecord record = RecordOf("ODOM 1.5 -2 0.25 0.3 0.1 0 1000.5 host 0.5");
  EXPECT_EQ(record.odom_from_base, Pose2(1.5, -2.0, 0.25));
  EXPECT_EQ(record.stamps.ipc, 1000.5);
  EXPECT_EQ(record.stamps.logger, 0.5);
  EXPECT_FALSE(record.scan);
}

TEST(CarmenLine, OdometryWithoutFinitePoseIsNone) {
  EXPECT_EQ(FaultOf("ODOM nan 2 0.25 0 0 0 1000.5 host 0.5"), kBadOdometry);
  EXPECT_EQ(FaultOf("ODOM 1 2 inf 0 0 0 1000.5 host 0.5"), kBadOdometry);
  EXPECT_EQ(FaultOf("ODOM 1 2 0 0 0 0"), kBadOdometry);
  EXPECT_EQ(FaultOf("ODOM"), kBadOdometry);
}

TEST(CarmenLine, OldStyleScanHasReadingsAndBothPoses) {
  const CarmenRecord record = RecordOf("FLASER 3 1.5 2.25 81.91 1 2 0.5 3 4 0.75 1000.5 host 0.5");
  EXPECT_THAT(record.scan->readings, ElementsAre(1.5f, 2.25f, 81.91f));
  EXPECT_EQ(record.scan->odom_from_laser, Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(record.odom_from_base, Pose2(3.0, 4.0, 0.75));
  EXPECT_EQ(record.stamps.ipc, 1000.5);
  EXPECT_TRUE(record.scan->beams_assumed);
}

TEST(CarmenLine, AReadingThatIsNoNumberSpoilsOnlyItself) {
  const CarmenRecord record = RecordOf("FLASER 3 1.5 1.#QNAN nan 1 2 0 1 2 0 1000.5 host 0.5");
  EXPECT_EQ(record.scan->readings[0], 1.5f);
  EXPECT_TRUE(std::isnan(record.scan->readings[1]));
  EXPECT_TRUE(std::isnan(record.scan->readings[2]));
}

TEST(CarmenLine, AScanWithoutFinitePoseOfTheRobotIsStillAScan) {
  const CarmenRecord record = RecordOf("FLASER 2 1.5 2 1 2 0 nan 2 0 1000.5 host 0.5");
  EXPECT_FALSE(record.odom_from_base);
  EXPECT_EQ(record.scan->readings.size(), 2u);
}

TEST(CarmenLine, HostAndLoggerTimeMayBeMissing) {
  EXPECT_EQ(RecordOf("FLASER 2 1.5 2 1 2 0 1 2 0 1000.5").stamps.ipc, 1000.5);
  EXPECT_EQ(RecordOf("FLASER 2 1.5 2 1 2 0 1 2 0 1000.5 host").stamps.logger, 0.0);
  EXPECT_EQ(RecordOf("ODOM 1 2 0 0 0 0 1000.5").stamps.ipc, 1000.5);
}

TEST(CarmenLine, ACountThatDoesNotFitTheLineIsAFault) {
  EXPECT_EQ(FaultOf("FLASER 4 1.5 2.25 81.91 1 2 0 1 2 0 1000.5 host 0.5"), kBadScan);
  EXPECT_EQ(FaultOf("FLASER 5 1.5 2.25 81.91 1 2 0 1 2 0 1000.5 host 0.5"), kBadScan);
  EXPECT_EQ(FaultOf("FLASER 2 1.5 2.25 81.91 1 2 0 1 2 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf("FLASER 1000000000 1.5 1 2 0 1 2 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf("FLASER 99999999999999999999 1 1 2 0 1 2 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf("FLASER -1 1.5 1 2 0 1 2 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf("FLASER 0 1 2 0 1 2 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf("FLASER"), kWrongCount);
}

TEST(CarmenLine, ALineThatBreaksOffMustBeComplete) {
  EXPECT_EQ(FaultOf("FLASER 2 1.5 2 1 2 0 1 2 0 1000.5 host 0", true), "");
  EXPECT_EQ(FaultOf("FLASER 2 1.5 2 1 2 0 1 2 0 100", true), kBadScan);
  EXPECT_EQ(FaultOf("ODOM 1 2 0 0 0 0 100", true), kBadOdometry);
}

constexpr char kGeometry[] = " 0 -1.5 3 0.5 30 0.01 0 ";

TEST(CarmenLine, RawLaserHasItsOwnGeometryAndNoPose) {
  const CarmenRecord record =
      RecordOf(std::string("RAWLASER1") + kGeometry + "3 1.5 2.25 30 2 7 8 1000.5 host 0.5");
  EXPECT_EQ(record.scan->beams, (BeamGeometry{3, -1.5, 0.5}));
  EXPECT_FALSE(record.scan->beams_assumed);
  EXPECT_EQ(record.scan->max_range, 30.0);
  EXPECT_THAT(record.scan->readings, ElementsAre(1.5f, 2.25f, 30.f));
  EXPECT_EQ(record.stamps.ipc, 1000.5);
  EXPECT_FALSE(record.odom_from_base);
}

TEST(CarmenLine, RobotLaserHasBothPosesBehindTheRemissions) {
  const CarmenRecord record =
      RecordOf(std::string("ROBOTLASER1") + kGeometry +
               "2 1.5 2.25 1 9 1 2 0.5 3 4 0.75 0 0 0.1 0.2 1e6 1000.5 host 0.5");
  EXPECT_EQ(record.scan->odom_from_laser, Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(record.odom_from_base, Pose2(3.0, 4.0, 0.75));
  EXPECT_EQ(record.stamps.logger, 0.5);
}

TEST(CarmenLine, AnAngularResolutionOfZeroFollowsFromTheFieldOfView) {
  const CarmenRecord record = RecordOf("RAWLASER1 0 -1.5 3 0 30 0.01 0 4 1 1 1 1 0 1000.5 h 0.5");
  EXPECT_EQ(record.scan->beams, (BeamGeometry{4, -1.5, 1.0}));
}

TEST(CarmenLine, BeamsOfMoreThanATurnAreAFault) {
  EXPECT_EQ(FaultOf("RAWLASER1 0 -1.5 3 5 30 0.01 0 4 1 1 1 1 0 1000.5 h 0.5"),
            "scan lines whose beams make no sense, skipped");
  EXPECT_EQ(FaultOf("RAWLASER1 0 nan 3 0.5 30 0.01 0 4 1 1 1 1 0 1000.5 h 0.5"),
            "scan lines whose beams make no sense, skipped");
}

TEST(CarmenLine, NewStyleCountsMustFitTheLine) {
  const std::string head = std::string("ROBOTLASER1") + kGeometry;
  EXPECT_EQ(FaultOf(head + "1000000000 1.5 2.25 0 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf(head + "2 1.5 2.25 1000000000 1000.5 host 0.5"), kWrongCount);
  EXPECT_EQ(FaultOf(head + "2 1.5 2.25 0 1 2 0.5 3 4 0.75"), kBadScan);
  EXPECT_EQ(FaultOf("RAWLASER1 0"), kWrongCount);
}

TEST(AssumedBeams, AreThoseOfTheScannerWithThisNumber) {
  const auto first_degrees = [](int n) { return RadiansToDegrees(AssumedBeams(n).Angle(0)); };
  const auto last_degrees = [](int n) { return RadiansToDegrees(AssumedBeams(n).Angle(n - 1)); };
  for (const int half_turn : {180, 181, 360, 361, 720, 721, 77}) {
    EXPECT_DOUBLE_EQ(first_degrees(half_turn), -90.0) << half_turn;
  }
  EXPECT_NEAR(last_degrees(180), 89.0, 1e-9);
  EXPECT_NEAR(last_degrees(181), 90.0, 1e-9);
  EXPECT_NEAR(last_degrees(360), 89.5, 1e-9);
  EXPECT_NEAR(last_degrees(361), 90.0, 1e-9);
  EXPECT_NEAR(first_degrees(401), -50.0, 1e-9);
  EXPECT_NEAR(last_degrees(401), 50.0, 1e-9);
  EXPECT_NEAR(last_degrees(541), 135.0, 1e-9);
  EXPECT_NEAR(last_degrees(1081), 135.0, 1e-9);
  EXPECT_NEAR(last_degrees(683), -first_degrees(683), 1e-9);
  EXPECT_NEAR(last_degrees(683) - first_degrees(683), 239.77, 0.01);
  EXPECT_EQ(AssumedBeams(1), (BeamGeometry{1, 0.0, 0.0}));
}

}  // namespace
}  // namespace loopscope
