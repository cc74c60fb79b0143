// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/scan_codec.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "core/io/recording_schema.h"

namespace loopscope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<LaserScan> Scans(const std::vector<std::vector<float>>& ranges) {
  std::vector<LaserScan> scans;
  for (const std::vector<float>& some : ranges) {
    const int index = static_cast<int>(scans.size());
    scans.push_back({1e9 + 0.123456 * index, index % 2, some, 3 * index});
  }
  return scans;
}

std::string Pack(const std::vector<LaserScan>& scans) {
  ByteWriter writer;
  PutScans(scans, &writer);
  return writer.bytes();
}

std::vector<LaserScan> Unpack(const std::string& bytes) {
  ByteReader reader(bytes, "a.file", "scans");
  std::vector<LaserScan> scans = GetScans(&reader);
  reader.ExpectEnd();
  return scans;
}

/// NaN as well as -0 are told apart.
std::vector<std::uint32_t> BitsOf(const std::vector<float>& numbers) {
  std::vector<std::uint32_t> bits(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(&bits[i], &numbers[i], 4);
  return bits;
}

void ExpectComeBack(const std::vector<LaserScan>& scans) {
  const std::vector<LaserScan> read = Unpack(Pack(scans));
  ASSERT_EQ(read.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(read[i].time, scans[i].time);
    EXPECT_EQ(read[i].beam_geometry, scans[i].beam_geometry);
    EXPECT_EQ(read[i].num_odometry_before, scans[i].num_odometry_before);
    ASSERT_EQ(read[i].ranges.size(), scans[i].ranges.size());
    EXPECT_EQ(BitsOf(read[i].ranges), BitsOf(scans[i].ranges)) << i;
  }
}

std::vector<float> RandomRanges(int count, double scale) {
  std::mt19937 random(1);
  std::vector<float> ranges;
  for (int i = 0; i < count; ++i) {
    const double range = std::uniform_real_distribution<>(0.1, 30.0)(random);
    ranges.push_back(static_cast<float>(scale == 0.0 ? range : std::round(range * scale) / scale));
  }
  return ranges;
}

TEST(ScanCodec, RangesComeBackBitForBit) {
  for (const double scale : {100.0, 1000.0, 10000.0, 0.0}) {
    ExpectComeBack(Scans({RandomRanges(180, scale), RandomRanges(361, scale), {}}));
  }
}

TEST(ScanCodec, NothingAndNonsenseComeBackAmongDistances) {
  ExpectComeBack(Scans({{1.25f, kInfinity, 1.5f, kNaN}, {kNaN, kInfinity}}));
}

TEST(ScanCodec, OddFloatsComeBackToo) {
  ExpectComeBack(Scans({{-0.f, 0.f, -kInfinity, 1e30f, -2.5f, -kNaN, 1.5f}}));
}

TEST(ScanCodec, WholeCentimetresTakeOneOrTwoBytes) {
  EXPECT_LT(Pack(Scans({RandomRanges(1000, 100.0)})).size(), 2100u);
  EXPECT_GT(Pack(Scans({RandomRanges(1000, 0.0)})).size(), 4000u);
}

TEST(ScanCodec, MoreRangesThanBytesThrow) {
  const std::string packed = Pack(Scans({{1.f, 2.f, 3.f}, {1.f}}));
  EXPECT_THROW(Unpack(packed.substr(0, packed.size() - 1)), FileError);
}

TEST(ScanCodec, DamagedBytesThrowOrGiveScans) {
  const std::string packed = Pack(Scans({RandomRanges(20, 100.0), RandomRanges(20, 100.0)}));
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = packed;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      EXPECT_LE(Unpack(damaged).size(), damaged.size());
    } catch (const FileError&) {
    }
  }
}

TEST(ScanCodec, OdometryComesBackBitForBit) {
  const std::vector<OdometryReading> odometry = {{1e9, Pose2(0.123456, -2.0, 0.5)},
                                                 {1e9 + 0.1, Pose2(M_PI, -0.0, 0.25)}};
  ByteWriter writer;
  PutOdometry(odometry, &writer);
  ByteReader reader(writer.bytes(), "a.file", "odometry");
  const std::vector<OdometryReading> read = GetOdometry(&reader);
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].time, odometry[i].time);
    EXPECT_EQ(read[i].odom_from_base, odometry[i].odom_from_base);
  }
}

TEST(ScanCodec, RefusesMoreScansThanAChunkHolds) {
  EXPECT_EQ(Unpack(Pack(std::vector<LaserScan>(kScansPerChunk))).size(), kScansPerChunk);
  EXPECT_THROW(Unpack(Pack(std::vector<LaserScan>(kScansPerChunk + 1))), FileError);
}

}  // namespace
}  // namespace loopscope
