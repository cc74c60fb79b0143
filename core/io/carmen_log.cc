// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_log.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/io/carmen_line.h"
#include "core/io/carmen_survey.h"
#include "core/io/carmen_times.h"
#include "core/io/file_error.h"
#include "core/io/line_reader.h"
#include "core/io/log_notes.h"
#include "core/io/no_return.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

// A day of scans at 20 Hz with 60 beams each, or an hour of a large scanner: 400 MB.
constexpr std::size_t kMaxRecords = 2'000'000;
constexpr std::size_t kMaxReadings = 100'000'000;
constexpr std::size_t kMaxBeamGeometries = 1000;

struct Records {
  std::vector<CarmenRecord> records;
  std::string first_fault = "their times are zero";  ///< of a line that should have been a scan
  int first_fault_line = 0;
};

/// The record of the line that `lines` stands on, if it is of a kind that is wanted.
std::optional<CarmenParse> ParseLine(const LineReader& lines, const std::string& scan_word,
                                     const std::vector<std::string_view>& words) {
  const bool is_scan = words.front() == scan_word;
  if (!is_scan && words.front() != "ODOM") return std::nullopt;
  if (lines.truncated()) return fmt::format("lines of more than {} bytes, skipped", kMaxLineLength);
  CarmenParse parse = is_scan ? ParseCarmenScan(words, lines.unfinished())
                              : ParseCarmenOdometry(words, lines.unfinished());
  if (lines.unfinished() && std::holds_alternative<std::string>(parse)) {
    return "last line breaks off, skipped";
  }
  return parse;
}

Records ReadRecords(const std::string& path, const std::string& scan_word, LogNotes* notes) {
  Records result;
  std::size_t num_readings = 0;
  LineReader lines(path);
  std::vector<std::string_view> words;
  while (const auto line = lines.Next()) {
    SplitWords(*line, &words);
    if (words.empty()) continue;
    std::optional<CarmenParse> parse = ParseLine(lines, scan_word, words);
    if (!parse) continue;
    if (const auto* const fault = std::get_if<std::string>(&*parse)) {
      notes->Add(*fault, lines.line_number());
      if (result.first_fault_line == 0 && words.front() == scan_word) {
        result.first_fault = *fault;
        result.first_fault_line = lines.line_number();
      }
      continue;
    }
    CarmenRecord& record = std::get<CarmenRecord>(*parse);
    record.line = lines.line_number();
    if (record.scan) num_readings += record.scan->readings.size();
    result.records.push_back(std::move(record));
    if (num_readings > kMaxReadings || result.records.size() > kMaxRecords) {
      throw FileError(path, lines.line_number(),
                      fmt::format("too long; expected at most {} readings and {} lines",
                                  kMaxReadings, kMaxRecords));
    }
  }
  if (lines.ends_early()) notes->Add("gzip data that end early", lines.line_number());
  return result;
}

/// Where the lines' own poses of the laser put it on the robot; nothing if they are the robot's own
/// poses, or (in a log that someone corrected) keep no fixed distance from them.
std::optional<Pose2> MountFromPoses(const std::vector<CarmenRecord>& records) {
  constexpr double kSameMetres = 5e-3;
  constexpr double kSameRadians = 5e-3;
  std::optional<Pose2> mount;
  for (const CarmenRecord& record : records) {
    if (!record.scan || !record.scan->odom_from_laser || !record.odom_from_base) continue;
    const Pose2 base_from_laser = record.odom_from_base->Inverse() * *record.scan->odom_from_laser;
    if (!mount) mount = base_from_laser;
    const Pose2 difference = mount->Inverse() * base_from_laser;
    if (difference.translation.norm() > kSameMetres ||
        std::abs(difference.rotation) > kSameRadians) {
      return std::nullopt;
    }
  }
  const bool apart = mount && (mount->translation.norm() > kSameMetres ||
                               std::abs(mount->rotation) > kSameRadians);
  return apart ? mount : std::nullopt;
}

int IndexOfBeams(const std::string& path, const CarmenRecord& record, ScanLog* log) {
  std::vector<BeamGeometry>& known = log->beam_geometries;
  const auto same = std::find(known.begin(), known.end(), record.scan->beams);
  if (same != known.end()) return static_cast<int>(same - known.begin());
  if (known.size() == kMaxBeamGeometries) {
    throw FileError(path, record.line,
                    fmt::format("more than {} kinds of scanners", kMaxBeamGeometries));
  }
  known.push_back(record.scan->beams);
  return static_cast<int>(known.size()) - 1;
}

void NoteBeams(const CarmenRecord& record, LogNotes* notes) {
  if (!record.scan->beams_assumed) return;
  const BeamGeometry& beams = record.scan->beams;
  notes->Add(
      fmt::format("scans of {} readings, taken as {:g} deg apart from {:g} deg on", beams.num_beams,
                  RadiansToDegrees(beams.angle_increment), RadiansToDegrees(beams.first_angle)),
      record.line);
}

void AddOdometry(double time, const CarmenRecord& record, ScanLog* log) {
  if (!record.odom_from_base) return;
  const bool repeats = record.scan && !log->odometry.empty() && log->odometry.back().time == time &&
                       log->odometry.back().odom_from_base == *record.odom_from_base;
  if (!repeats) log->odometry.push_back({time, *record.odom_from_base});
}

/// Poses that never change say nothing about motion.
void DropOdometryWithoutMotion(ScanLog* log, LogNotes* notes) {
  const auto stands = [log](const OdometryReading& reading) {
    return reading.odom_from_base == log->odometry.front().odom_from_base;
  };
  if (log->odometry.empty() || !std::all_of(log->odometry.begin(), log->odometry.end(), stands)) {
    return;
  }
  notes->Add("odometry poses that never change, dropped", 1,
             static_cast<int>(log->odometry.size()));
  log->odometry.clear();
  for (LaserScan& scan : log->scans) scan.num_odometry_before = 0;
}

}  // namespace

ScanLog ReadCarmenLog(const std::string& path) {
  LogNotes notes;
  const CarmenSurvey survey = SurveyCarmenLog(path, &notes);
  if (survey.scan_word.empty()) {
    throw FileError(path,
                    "no scan; expected a CARMEN log with FLASER, ROBOTLASER or RAWLASER lines");
  }
  Records read = ReadRecords(path, survey.scan_word, &notes);
  const std::vector<double> times = ResolveTimes(&read.records, &notes);
  CleanReadings(survey.max_range, &read.records, &notes);
  ScanLog log;
  log.name = std::filesystem::path(path).filename().string();
  log.base_from_laser = MountFromPoses(read.records).value_or(survey.base_from_laser);
  for (std::size_t i = 0; i < read.records.size(); ++i) {
    CarmenRecord& record = read.records[i];
    AddOdometry(times[i], record, &log);
    if (!record.scan) continue;
    NoteBeams(record, &notes);
    log.scans.push_back({times[i], IndexOfBeams(path, record, &log),
                         std::move(record.scan->readings), static_cast<int>(log.odometry.size())});
  }
  if (log.scans.empty()) {
    throw FileError(path, std::max(read.first_fault_line, 1),
                    "no scan can be read: " + read.first_fault);
  }
  DropOdometryWithoutMotion(&log, &notes);
  log.notes = notes.notes();
  return log;
}

}  // namespace loopscope
