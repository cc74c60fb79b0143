// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_writer.h"

#include <cassert>
#include <cmath>
#include <iterator>
#include <zlib.h>

#include <fmt/format.h>

#include "core/io/replace_file.h"

namespace loopscope {
namespace {

constexpr float kNoReturn = 81.91f;  // what SICK scanners say where nothing came back [m]

template <typename... Values>
void Append(std::string* text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(*text), format, std::forward<Values>(values)...);
}

// Whether readers of FLASER lines know the directions of the beams from their number.
bool IsOldStyle(const BeamGeometry& beams) {
  const bool one_degree = beams.num_beams == 180 || beams.num_beams == 181;
  const bool half_degree = beams.num_beams == 360 || beams.num_beams == 361;
  const double increment = DegreesToRadians(one_degree ? 1.0 : 0.5);
  return (one_degree || half_degree) && std::abs(beams.angle_increment - increment) < 1e-9 &&
         std::abs(beams.first_angle + DegreesToRadians(90.0)) < 1e-9;
}

void AppendPose(const Pose2& pose, std::string* text) {
  Append(text, " {:.6f} {:.6f} {:.6f}", pose.x(), pose.y(), pose.rotation);
}

void AppendStamp(double time, std::string* text) {
  Append(text, " {:.6f} loopscope {:.6f}\n", time, time);
}

void AppendRanges(const LaserScan& scan, std::string* text) {
  Append(text, " {}", scan.ranges.size());
  for (const float range : scan.ranges) {
    Append(text, " {}", std::isnan(range) ? 0.0f : std::isinf(range) ? kNoReturn : range);
  }
}

void AppendOldStyleScan(const LaserScan& scan, const Pose2& odom_from_laser,
                        const Pose2& odom_from_base, std::string* text) {
  *text += "FLASER";
  AppendRanges(scan, text);
  AppendPose(odom_from_laser, text);
  AppendPose(odom_from_base, text);
  AppendStamp(scan.time, text);
}

void AppendRobotLaser(const LaserScan& scan, const BeamGeometry& beams,
                      const Pose2& odom_from_laser, const Pose2& odom_from_base,
                      std::string* text) {
  // Type, directions, maximum range, accuracy, remission mode.
  Append(text, "ROBOTLASER1 0 {:.9f} {:.9f} {:.9f} {} 0.01 0", beams.first_angle,
         beams.angle_increment * (beams.num_beams - 1), beams.angle_increment, kNoReturn);
  AppendRanges(scan, text);
  *text += " 0";  // remissions
  AppendPose(odom_from_laser, text);
  AppendPose(odom_from_base, text);
  *text += " 0 0 0 0 0";  // speeds, safety distances, turn axis
  AppendStamp(scan.time, text);
}

void AppendScan(const ScanLog& log, const LaserScan& scan, const Pose2& odom_from_base,
                std::string* text) {
  const BeamGeometry& beams = log.beam_geometries[scan.beam_geometry];
  const Pose2 odom_from_laser = odom_from_base * log.base_from_laser;
  if (IsOldStyle(beams)) {
    AppendOldStyleScan(scan, odom_from_laser, odom_from_base, text);
  } else {
    AppendRobotLaser(scan, beams, odom_from_laser, odom_from_base, text);
  }
}

// The bytes are the same each time: no name and no date stand in the header.
std::string Gzip(const std::string& text) {
  constexpr int kGzipWindow = 15 + 16;
  z_stream stream = {};
  [[maybe_unused]] int result =
      deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY);
  assert(result == Z_OK);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  result = deflate(&stream, Z_FINISH);
  assert(result == Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

bool EndsInGz(const std::string& path) {
  return path.size() >= 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
}

}  // namespace

std::string CarmenText(const ScanLog& log) {
  std::string text;
  Append(&text, "# {}, written by Loopscope\n", log.name);
  Append(&text, "PARAM robot_frontlaser_offset {} loopscope 0\n", log.base_from_laser.x());
  Append(&text, "PARAM robot_front_laser_max {} loopscope 0\n", std::floor(kNoReturn));
  size_t scan = 0;
  while (scan < log.scans.size() && log.scans[scan].num_odometry_before == 0) ++scan;
  for (int i = 0; i < static_cast<int>(log.odometry.size()); ++i) {
    const OdometryReading& reading = log.odometry[i];
    text += "ODOM";
    AppendPose(reading.odom_from_base, &text);
    text += " 0 0 0";  // speeds and acceleration
    AppendStamp(reading.time, &text);
    for (; scan < log.scans.size() && log.scans[scan].num_odometry_before == i + 1; ++scan) {
      AppendScan(log, log.scans[scan], reading.odom_from_base, &text);
    }
  }
  return text;
}

void WriteCarmenLog(const std::string& path, const ScanLog& log) {
  const std::string text = CarmenText(log);
  ReplaceFile(path, EndsInGz(path) ? Gzip(text) : text);
}

}  // namespace loopscope
