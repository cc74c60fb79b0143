// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/scan_codec.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/io/bits.h"
#include "core/io/number_codec.h"
#include "core/io/recording_schema.h"

namespace loopscope {
namespace {

/// Multiples of 1 / scale [m] are tried in this order. Index 0 stands for none. Part of the format.
constexpr std::array<double, 4> kScales = {0.0, 1e2, 1e3, 1e4};

// How a range is coded as a multiple: these two, or kFirstDifference + its difference to the last
// one that was a distance, folded so that it is not negative.
constexpr std::uint64_t kInvalid = 0;
constexpr std::uint64_t kNoReturn = 1;
constexpr std::uint64_t kFirstDifference = 2;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::int64_t Multiple(float range, double scale) {
  constexpr float kFarthest = 1e6f;
  return range > 0.f && range < kFarthest ? std::llround(static_cast<double>(range) * scale) : 0;
}

float FromMultiple(std::int64_t multiple, double scale) {
  return static_cast<float>(static_cast<double>(multiple) / scale);
}

bool IsExact(float range, double scale) {
  const std::uint32_t bits = BitsOf(range);
  return bits == BitsOf(kNaN) || bits == BitsOf(kInfinity) ||
         bits == BitsOf(FromMultiple(Multiple(range, scale), scale));
}

bool AllExact(const std::vector<LaserScan>& scans, double scale) {
  for (const LaserScan& scan : scans) {
    for (const float range : scan.ranges) {
      if (!IsExact(range, scale)) return false;
    }
  }
  return true;
}

std::uint8_t ChooseScale(const std::vector<LaserScan>& scans) {
  for (std::uint8_t i = 1; i < kScales.size(); ++i) {
    if (AllExact(scans, kScales[i])) return i;
  }
  return 0;
}

void PutRanges(const std::vector<float>& ranges, double scale, ByteWriter* out) {
  std::int64_t last = 0;
  for (const float range : ranges) {
    if (std::isnan(range)) {
      out->PutUnsigned(kInvalid);
    } else if (std::isinf(range)) {
      out->PutUnsigned(kNoReturn);
    } else {
      const std::int64_t multiple = Multiple(range, scale);
      const std::int64_t difference = multiple - last;
      const auto folded =
          static_cast<std::uint64_t>(difference < 0 ? -2 * difference - 1 : 2 * difference);
      out->PutUnsigned(kFirstDifference + folded);
      last = multiple;
    }
  }
}

void GetRanges(double scale, ByteReader* in, std::vector<float>* ranges) {
  std::uint64_t last = 0;  // unsigned, so that damaged data may overflow
  for (float& range : *ranges) {
    const std::uint64_t code = in->GetUnsigned();
    if (code == kInvalid) {
      range = kNaN;
    } else if (code == kNoReturn) {
      range = kInfinity;
    } else {
      const std::uint64_t folded = code - kFirstDifference;
      last += (folded & 1) != 0 ? ~(folded >> 1) : folded >> 1;
      range = FromMultiple(static_cast<std::int64_t>(last), scale);
    }
  }
}

std::vector<double> TimesOf(const std::vector<LaserScan>& scans) {
  std::vector<double> times;
  for (const LaserScan& scan : scans) times.push_back(scan.time);
  return times;
}

int GetInt(ByteReader* in) {
  const std::uint64_t value = in->GetUnsigned();
  if (value > std::numeric_limits<int>::max()) in->Fail("a number is too large");
  return static_cast<int>(value);
}

}  // namespace

void PutScans(const std::vector<LaserScan>& scans, ByteWriter* out) {
  PutDoubles(TimesOf(scans), {}, out);
  const std::uint8_t scale = ChooseScale(scans);
  out->PutByte(scale);
  for (const LaserScan& scan : scans) {
    out->PutUnsigned(static_cast<std::uint64_t>(scan.beam_geometry));
    out->PutUnsigned(static_cast<std::uint64_t>(scan.num_odometry_before));
    out->PutUnsigned(scan.ranges.size());
  }
  for (const LaserScan& scan : scans) {
    if (scale != 0) {
      PutRanges(scan.ranges, kScales[scale], out);
    } else {
      for (const float range : scan.ranges) out->PutBits32(BitsOf(range));
    }
  }
}

std::vector<LaserScan> GetScans(ByteReader* in) {
  const std::vector<double> times = GetDoubles({}, in);
  if (times.size() > kScansPerChunk) in->Fail("too many scans");
  const std::uint8_t scale = in->GetByte();
  if (scale >= kScales.size()) in->Fail("an unknown scale");
  std::vector<LaserScan> scans(times.size());
  std::vector<std::size_t> num_ranges(times.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].time = times[i];
    scans[i].beam_geometry = GetInt(in);
    scans[i].num_odometry_before = GetInt(in);
    num_ranges[i] = in->GetCount();
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {
    in->ExpectLeft(num_ranges[i]);
    scans[i].ranges.resize(num_ranges[i]);
    if (scale != 0) {
      GetRanges(kScales[scale], in, &scans[i].ranges);
    } else {
      for (float& range : scans[i].ranges) range = FloatOf(in->GetBits32());
    }
  }
  return scans;
}

void PutOdometry(const std::vector<OdometryReading>& odometry, ByteWriter* out) {
  std::vector<double> times;
  std::vector<Pose2> poses;
  for (const auto& [time, pose] : odometry) {
    times.push_back(time);
    poses.push_back(pose);
  }
  PutDoubles(times, {}, out);
  PutPoses(poses, {}, out);
}

std::vector<OdometryReading> GetOdometry(ByteReader* in) {
  const std::vector<double> times = GetDoubles({}, in);
  const std::vector<Pose2> poses = GetPoses({}, in);
  if (times.size() != poses.size()) in->Fail("columns differ in length");
  if (times.size() > kOdometryPerChunk) in->Fail("there are too many readings");
  std::vector<OdometryReading> odometry;
  odometry.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) odometry.push_back({times[i], poses[i]});
  return odometry;
}

}  // namespace loopscope
