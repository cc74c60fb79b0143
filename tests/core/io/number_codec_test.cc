// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/number_codec.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

using Values = std::vector<double>;

bool SameBits(const Values& a, const Values& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

std::string Pack(const Values& values, const Values& predictions = {}) {
  ByteWriter writer;
  PutDoubles(values, predictions, &writer);
  return writer.bytes();
}

Values Unpack(const std::string& bytes, const Values& predictions = {}) {
  ByteReader reader(bytes, "a.file", "numbers");
  const Values values = GetDoubles(predictions, &reader);
  reader.ExpectEnd();
  return values;
}

Values RandomValues(int count, double scale) {
  std::mt19937 random(1);
  Values values;
  double value = 0.0;
  for (int i = 0; i < count; ++i) {
    value += std::uniform_real_distribution<>(-1.0, 1.0)(random);
    values.push_back(scale == 0.0 ? value : std::round(value * scale) / scale);
  }
  return values;
}

TEST(NumberCodec, AllDoublesComeBackBitForBit) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Values odd = {0.0,    -0.0,  infinity, -infinity, std::nan("1"),
                      5e-324, 1e308, -1e308,   0.1,       M_PI};
  EXPECT_TRUE(SameBits(Unpack(Pack(odd)), odd));
  EXPECT_TRUE(SameBits(Unpack(Pack({})), {}));
  for (const double scale : {0.0, 1.0, 100.0, 1e6, 1e9, 0x1p20, 0x1p30}) {
    const Values values = RandomValues(1000, scale);
    EXPECT_TRUE(SameBits(Unpack(Pack(values)), values)) << scale;
    const Values predictions = RandomValues(700, 0.0);
    EXPECT_TRUE(SameBits(Unpack(Pack(values, predictions), predictions), values)) << scale;
  }
}

TEST(NumberCodec, AFewOddOnesAmongMultiplesComeBackToo) {
  Values values = RandomValues(1000, 1e6);
  values[0] = -0.0;
  values[17] = M_PI;
  values[999] = 1e300;
  const std::string packed = Pack(values);
  EXPECT_LT(packed.size(), 1000u * 4);
  EXPECT_TRUE(SameBits(Unpack(packed), values));
}

TEST(NumberCodec, MultiplesAreShort) {
  EXPECT_LT(Pack(RandomValues(1000, 100.0)).size(), 1000u * 2 + 10);
  EXPECT_LT(Pack(RandomValues(1000, 0x1p20)).size(), 1000u * 3 + 10);
}

TEST(NumberCodec, GoodPredictionsMakeItShorterEvenIfAllAreOffAlike) {
  const Values values = RandomValues(1000, 0x1p20);
  Values predictions = values;
  for (double& prediction : predictions) prediction += 0.5;
  EXPECT_LT(Pack(values, predictions).size(), 1000u * 1 + 10);
}

TEST(NumberCodec, MoreValuesThanBytesThrow) {
  ByteWriter writer;
  writer.PutUnsigned(1000000000);
  writer.PutByte(0);
  EXPECT_THROW(Unpack(writer.bytes() + "abc"), FileError);
}

TEST(NumberCodec, DamagedBytesThrowOrGiveNumbers) {
  const std::string packed = Pack(RandomValues(30, 1e6));
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

TEST(NumberCodec, PosesComeBackBitForBit) {
  const std::vector<Pose2> poses = {Pose2(0.1, -0.2, 0.3), Pose2(-0.0, 1e9, -3.0), Pose2()};
  ByteWriter writer;
  PutPoses(poses, {Pose2(0.1, 0.0, 0.0)}, &writer);
  ByteReader reader(writer.bytes(), "a.file", "poses");
  const std::vector<Pose2> read = GetPoses({Pose2(0.1, 0.0, 0.0)}, &reader);
  ASSERT_EQ(read.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read[i], poses[i]);
  EXPECT_TRUE(std::signbit(read[1].x()));
}

}  // namespace
}  // namespace loopscope
