// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulation_writer.h"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

#include <fmt/ostream.h>

namespace loopscope {
namespace {

constexpr float kNoReturn = 81.91f;  // what SICK scanners say where nothing came back [m]

// Whether a reader of FLASER lines knows the directions of the beams from their number.
bool IsOldStyle(const BeamGeometry& beams) {
  const bool one_degree = beams.num_beams == 180 || beams.num_beams == 181;
  const bool half_degree = beams.num_beams == 360 || beams.num_beams == 361;
  const double increment = DegreesToRadians(one_degree ? 1.0 : 0.5);
  return (one_degree || half_degree) && std::abs(beams.angle_increment - increment) < 1e-9 &&
         std::abs(beams.first_angle + DegreesToRadians(90.0)) < 1e-9;
}

void WritePose(const Pose2& pose, std::ostream& out) {
  fmt::print(out, " {:.6f} {:.6f} {:.6f}", pose.x(), pose.y(), pose.rotation);
}

void WriteStamp(double time, std::ostream& out) {
  fmt::print(out, " {:.6f} simulated {:.6f}\n", time, time);
}

void WriteRanges(const LaserScan& scan, std::ostream& out) {
  fmt::print(out, " {}", scan.ranges.size());
  for (const float range : scan.ranges) {
    fmt::print(out, " {}", std::isnan(range) ? 0.0f : std::isinf(range) ? kNoReturn : range);
  }
}

void WriteScan(const ScanLog& log, const LaserScan& scan, const Pose2& odom_from_base,
               std::ostream& out) {
  const BeamGeometry& beams = log.beam_geometries[scan.beam_geometry];
  const bool old_style = IsOldStyle(beams);
  if (old_style) {
    out << "FLASER";
  } else {
    // Type, directions, maximum range, accuracy, remission mode.
    fmt::print(out, "ROBOTLASER1 0 {:.9f} {:.9f} {:.9f} {} 0.01 0", beams.first_angle,
               beams.angle_increment * (beams.num_beams - 1), beams.angle_increment, kNoReturn);
  }
  WriteRanges(scan, out);
  if (!old_style) out << " 0";
  WritePose(odom_from_base * log.base_from_laser, out);
  WritePose(odom_from_base, out);
  // Speeds, safety distances and turn axis.
  if (!old_style) out << " 0 0 0 0 0";
  WriteStamp(scan.time, out);
}

// The nearest earlier keyframe within a metre from which the robot had been away.
std::optional<size_t> EarlierVisit(const Trajectory& keyframes, size_t i) {
  constexpr double kSamePlace = 1.0;  // [m]
  constexpr size_t kNumKeyframesAway = 8;
  std::optional<size_t> nearest;
  double nearest_distance = kSamePlace;
  for (size_t j = 0; j + kNumKeyframesAway <= i; ++j) {
    const double distance =
        (keyframes[j].map_from_base.translation - keyframes[i].map_from_base.translation).norm();
    if (distance > nearest_distance) continue;
    nearest = j;
    nearest_distance = distance;
  }
  return nearest;
}

Trajectory Keyframes(const Trajectory& trajectory) {
  constexpr double kSpacing = 1.0;  // [m]
  Trajectory keyframes;
  for (const TimedPose& pose : trajectory) {
    if (keyframes.empty() ||
        (pose.map_from_base.translation - keyframes.back().map_from_base.translation).norm() >=
            kSpacing) {
      keyframes.push_back(pose);
    }
  }
  return keyframes;
}

void WriteRelation(const TimedPose& first, const TimedPose& second, std::ostream& out) {
  const Pose2 first_from_second = first.map_from_base.Inverse() * second.map_from_base;
  fmt::print(out, "{:.6f} {:.6f} {:.6f} {:.6f} 0 0 0 {:.6f}\n", first.time, second.time,
             first_from_second.x(), first_from_second.y(), first_from_second.rotation);
}

void SaveText(const std::string& text, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

void SaveGzip(const std::string& text, const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "wb9");
  if (!file) throw std::runtime_error(path + ": cannot be written");
  const size_t written = gzfwrite(text.data(), 1, text.size(), file);
  if (gzclose(file) != Z_OK || written != text.size()) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string WithoutEnd(const std::string& text, const std::string& end) {
  return EndsWith(text, end) ? text.substr(0, text.size() - end.size()) : text;
}

template <typename Writer, typename Value>
std::string TextOf(Writer writer, const Value& value) {
  std::ostringstream text;
  writer(value, text);
  return text.str();
}

}  // namespace

void WriteCarmenLog(const ScanLog& log, std::ostream& out) {
  fmt::print(out, "# simulated by Loopscope: {}\n", log.name);
  fmt::print(out, "PARAM robot_frontlaser_offset {} simulated 0\n", log.base_from_laser.x());
  fmt::print(out, "PARAM robot_front_laser_max {} simulated 0\n", 81.0);
  size_t scan = 0;
  for (size_t i = 0; i < log.odometry.size(); ++i) {
    const OdometryReading& reading = log.odometry[i];
    out << "ODOM";
    WritePose(reading.odom_from_base, out);
    out << " 0 0 0";  // speeds and acceleration
    WriteStamp(reading.time, out);
    const int num_readings = static_cast<int>(i) + 1;
    for (; scan < log.scans.size() && log.scans[scan].num_odometry_before == num_readings; ++scan) {
      WriteScan(log, log.scans[scan], reading.odom_from_base, out);
    }
  }
}

void WriteRelations(const Trajectory& map_from_base, std::ostream& out) {
  const Trajectory keyframes = Keyframes(map_from_base);
  for (size_t i = 1; i < keyframes.size(); ++i) {
    WriteRelation(keyframes[i - 1], keyframes[i], out);
    const std::optional<size_t> earlier = EarlierVisit(keyframes, i);
    if (earlier) WriteRelation(keyframes[*earlier], keyframes[i], out);
  }
}

void WriteTumTrajectory(const Trajectory& map_from_base, std::ostream& out) {
  for (const TimedPose& pose : map_from_base) {
    const double half_angle = pose.map_from_base.rotation / 2.0;
    fmt::print(out, "{:.6f} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n", pose.time, pose.map_from_base.x(),
               pose.map_from_base.y(), std::sin(half_angle), std::cos(half_angle));
  }
}

SimulationFiles SaveSimulation(const Simulation& simulation, const std::string& log_path) {
  const std::string stem = WithoutEnd(WithoutEnd(log_path, ".gz"), ".log");
  const SimulationFiles files{log_path, stem + ".relations", stem + ".tum"};
  const std::string log = TextOf(WriteCarmenLog, simulation.log);
  EndsWith(log_path, ".gz") ? SaveGzip(log, files.log) : SaveText(log, files.log);
  SaveText(TextOf(WriteRelations, simulation.ground_truth), files.relations);
  SaveText(TextOf(WriteTumTrajectory, simulation.ground_truth), files.ground_truth);
  return files;
}

}  // namespace loopscope
