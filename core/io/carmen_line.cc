// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_line.h"

#include <cmath>

#include "core/io/words.h"

namespace loopscope {
namespace {

using Words = std::vector<std::string_view>;

constexpr char kWrongCount[] = "scan lines with a wrong count of readings, skipped";
constexpr char kBadGeometry[] = "scan lines whose beams make no sense, skipped";
constexpr char kBadScan[] = "scan lines without readable pose and time, skipped";
constexpr char kBadOdometry[] = "ODOM lines without readable pose and time, skipped";

double NumberAt(const Words& words, std::size_t index) {
  return ParseDouble(words[index]).value_or(std::nan(""));
}

/// The pose in words[index ... index + 2]; nothing if it is not finite.
std::optional<Pose2> PoseAtWord(const Words& words, std::size_t index) {
  const Pose2 pose(NumberAt(words, index), NumberAt(words, index + 1), NumberAt(words, index + 2));
  if (!pose.translation.allFinite() || !std::isfinite(pose.rotation)) return std::nullopt;
  return pose;
}

bool AreNumbers(const Words& words, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (!ParseDouble(words[i])) return false;
  }
  return true;
}

/// "ipc_time host logger_time" from words[index] to the end, of which only the first is a must. A
/// line that was cut off must have all, as its last word may be half a number.
std::optional<CarmenStamps> StampsAt(const Words& words, std::size_t index, bool cut_off) {
  const std::size_t num_left = words.size() - std::min(index, words.size());
  if (num_left < (cut_off ? 3 : 1) || num_left > 3) return std::nullopt;
  const std::optional<double> ipc = ParseDouble(words[index]);
  if (!ipc) return std::nullopt;
  const double logger = num_left == 3 ? NumberAt(words, index + 2) : 0.0;
  return CarmenStamps{std::isfinite(*ipc) ? *ipc : 0.0, std::isfinite(logger) ? logger : 0.0};
}

std::vector<float> ReadingsAt(const Words& words, std::size_t index, std::size_t count) {
  std::vector<float> readings;
  readings.reserve(count);
  for (std::size_t i = index; i < index + count; ++i) {
    readings.push_back(static_cast<float>(NumberAt(words, i)));
  }
  return readings;
}

/// The count in words[index] if so many words follow it.
std::optional<std::size_t> CountAt(const Words& words, std::size_t index) {
  if (index >= words.size()) return std::nullopt;
  const std::optional<int> count = ParseInt(words[index]);
  if (!count || *count < 0) return std::nullopt;
  const auto wanted = static_cast<std::size_t>(*count);
  if (wanted > words.size() - index - 1) return std::nullopt;
  return wanted;
}

CarmenParse ParseOldStyle(const Words& words, bool cut_off) {
  const std::optional<std::size_t> count = CountAt(words, 1);
  constexpr std::size_t kNumPoseWords = 6;
  if (!count || *count == 0 || words.size() < 2 + *count + kNumPoseWords + 1 ||
      words.size() > 2 + *count + kNumPoseWords + 3) {
    return kWrongCount;
  }
  const std::size_t poses = 2 + *count;
  const auto stamps = StampsAt(words, poses + kNumPoseWords, cut_off);
  if (!AreNumbers(words, poses, poses + kNumPoseWords) || !stamps) return kBadScan;
  CarmenScan scan;
  scan.beams = AssumedBeams(static_cast<int>(*count));
  scan.beams_assumed = true;
  scan.readings = ReadingsAt(words, 2, *count);
  scan.odom_from_laser = PoseAtWord(words, poses);
  return CarmenRecord{0, *stamps, PoseAtWord(words, poses + 3), std::move(scan)};
}

/// laser_type start_angle field_of_view angular_resolution maximum_range accuracy remission_mode
/// from words[1] on.
std::optional<BeamGeometry> ExplicitBeams(const Words& words, std::size_t count) {
  BeamGeometry beams{static_cast<int>(count), NumberAt(words, 2), NumberAt(words, 4)};
  if (beams.angle_increment == 0.0 && count > 1) {
    beams.angle_increment = NumberAt(words, 3) / static_cast<double>(count - 1);
  }
  const double span = beams.angle_increment * static_cast<double>(count - 1);
  constexpr double kWholeTurn = 2.0 * M_PI + 1e-2;
  const bool sensible = std::abs(beams.first_angle) < kWholeTurn && std::abs(span) < kWholeTurn &&
                        (count == 1 || beams.angle_increment != 0.0);
  return sensible ? std::make_optional(beams) : std::nullopt;
}

CarmenParse ParseNewStyle(const Words& words, bool with_poses, bool cut_off) {
  constexpr std::size_t kCount = 8;
  const std::optional<std::size_t> count = CountAt(words, kCount);
  if (!count || *count == 0) return kWrongCount;
  const std::size_t remissions = kCount + 1 + *count;
  const std::optional<std::size_t> num_remissions = CountAt(words, remissions);
  if (!num_remissions) return kWrongCount;
  const std::size_t poses = remissions + 1 + *num_remissions;
  const std::size_t num_pose_words = with_poses ? 11 : 0;
  const auto stamps = StampsAt(words, poses + num_pose_words, cut_off);
  if (!stamps || !AreNumbers(words, poses, poses + num_pose_words)) return kBadScan;
  const std::optional<BeamGeometry> beams = ExplicitBeams(words, *count);
  if (!beams) return kBadGeometry;
  CarmenScan scan;
  scan.beams = *beams;
  if (const double announced = NumberAt(words, 5); announced > 0.0) scan.max_range = announced;
  scan.readings = ReadingsAt(words, kCount + 1, *count);
  CarmenRecord record{0, *stamps, std::nullopt, std::nullopt};
  if (with_poses) {
    scan.odom_from_laser = PoseAtWord(words, poses);
    record.odom_from_base = PoseAtWord(words, poses + 3);
  }
  record.scan = std::move(scan);
  return record;
}

}  // namespace

std::optional<ScanLayout> LayoutOf(std::string_view word) {
  if (word == "FLASER" || word == "RLASER") return ScanLayout::kOldStyle;
  if (word.empty() || word.back() < '0' || word.back() > '9') return std::nullopt;
  word.remove_suffix(1);
  if (word == "RAWLASER") return ScanLayout::kRawLaser;
  if (word == "ROBOTLASER") return ScanLayout::kRobotLaser;
  return std::nullopt;
}

CarmenParse ParseCarmenOdometry(const std::vector<std::string_view>& words, bool cut_off) {
  constexpr std::size_t kStamps = 7;  // after ODOM x y theta tv rv accel
  const auto stamps = StampsAt(words, kStamps, cut_off);
  if (!stamps) return kBadOdometry;
  const std::optional<Pose2> pose = PoseAtWord(words, 1);
  if (!pose) return kBadOdometry;
  return CarmenRecord{0, *stamps, pose, std::nullopt};
}

CarmenParse ParseCarmenScan(const std::vector<std::string_view>& words, bool cut_off) {
  const ScanLayout layout = LayoutOf(words.front()).value();
  if (layout == ScanLayout::kOldStyle) return ParseOldStyle(words, cut_off);
  return ParseNewStyle(words, layout == ScanLayout::kRobotLaser, cut_off);
}

BeamGeometry AssumedBeams(int num_beams) {
  const auto evenly = [num_beams](double first_degrees, double step_degrees) {
    return BeamGeometry{num_beams, DegreesToRadians(first_degrees), DegreesToRadians(step_degrees)};
  };
  switch (num_beams) {
    case 1:
      return evenly(0.0, 0.0);
    case 101:  // SICK LMS at 100 degrees
    case 201:
    case 401:
      return evenly(-50.0, 100.0 / (num_beams - 1));
    case 541:   // SICK LMS1xx
    case 1081:  // Hokuyo UTM-30LX
      return evenly(-135.0, 270.0 / (num_beams - 1));
    case 682:  // Hokuyo URG-04LX: 1024 steps a turn
    case 683:
      return evenly(-(num_beams - 1) / 2.0 * 360.0 / 1024.0, 360.0 / 1024.0);
    default:  // 181 beams have a last one at +90 degrees, 180 have not
      return evenly(-90.0, 180.0 / (num_beams % 2 == 0 ? num_beams : num_beams - 1));
  }
}

}  // namespace loopscope
