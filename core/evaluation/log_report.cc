// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/log_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/evaluation/statistics.h"
#include "core/geometry/leap.h"
#include "core/local/used_odometry.h"
#include "core/slam/options.h"

namespace loopscope {
namespace {

void ReportTimes(const ScanLog& log, LogReport* report) {
  std::vector<double> periods;
  double first = log.scans.front().time;
  double last = first;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    const double time = log.scans[i].time;
    const double period = time - log.scans[i - 1].time;
    periods.push_back(period);
    first = std::min(first, time);
    last = std::max(last, time);
    if (period > report->longest_pause) {
      report->longest_pause = period;
      report->scan_after_pause = static_cast<int>(i);
    }
  }
  report->duration = last - first;
  report->scan_period = StatisticsOf(std::move(periods)).median;
}

/// From the reading before to reading `i`.
Pose2 MotionTo(std::size_t i, const std::vector<OdometryReading>& odometry) {
  return odometry[i - 1].odom_from_base.Inverse() * odometry[i].odom_from_base;
}

void ReportWay(const ScanLog& log, LogReport* report) {
  for (std::size_t i = 1; i < log.odometry.size(); ++i) {
    const Pose2 motion = MotionTo(i, log.odometry);
    if (!IsLeap(motion)) report->odometry_length += motion.translation.norm();
  }
  std::vector<double> distances;
  for (int scan = 1; scan < static_cast<int>(log.scans.size()); ++scan) {
    const auto before = OdometryOfScan(log, scan - 1);
    const auto here = OdometryOfScan(log, scan);
    if (!before || !here) continue;
    distances.push_back(
        (here->odom_from_base.translation - before->odom_from_base.translation).norm());
  }
  report->scan_distance = StatisticsOf(std::move(distances)).median;
}

void ReportRanges(const ScanLog& log, LogReport* report) {
  std::vector<double> returns;
  double num_nothing = 0.0;
  double num_invalid = 0.0;
  for (const LaserScan& scan : log.scans) {
    for (const float range : scan.ranges) {
      if (std::isnan(range)) {
        ++num_invalid;
      } else if (std::isinf(range)) {
        ++num_nothing;
      } else {
        returns.push_back(range);
        report->largest_range = std::max(report->largest_range, static_cast<double>(range));
      }
    }
  }
  const double num_readings = static_cast<double>(returns.size()) + num_nothing + num_invalid;
  if (num_readings == 0.0) return;
  report->share_of_returns = static_cast<double>(returns.size()) / num_readings;
  report->share_of_nothing = num_nothing / num_readings;
  report->share_of_invalid = num_invalid / num_readings;
  report->median_range = StatisticsOf(std::move(returns)).median;
}

/// Stamps that run backwards: how often, and by how much at most [s].
struct Backwards {
  int count = 0;
  double most = 0.0;
};

template <typename Item>
Backwards BackwardsIn(const std::vector<Item>& items) {
  Backwards backwards;
  for (std::size_t i = 1; i < items.size(); ++i) {
    const double back = items[i - 1].time - items[i].time;
    if (back <= 0.0) continue;
    ++backwards.count;
    backwards.most = std::max(backwards.most, back);
  }
  return backwards;
}

/// Motion that no robot on wheels makes.
struct Jumps {
  int count = 0;
  std::size_t first_reading = 0;
  Pose2 first;
};

Jumps JumpsOf(const std::vector<OdometryReading>& odometry) {
  constexpr double kShortestTime = 0.2;  // [s] stamps are no better than that
  constexpr double kFastest = 5.0;       // [m/s]
  const double fastest_turn = DegreesToRadians(270.0);
  Jumps jumps;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Pose2 motion = MotionTo(i, odometry);
    const double time = std::max(odometry[i].time - odometry[i - 1].time, kShortestTime);
    if (IsLeap(motion)) continue;  // told by itself
    if (motion.translation.norm() < kFastest * time &&
        std::abs(motion.rotation) < fastest_turn * time) {
      continue;
    }
    if (jumps.count++ == 0) {
      jumps.first_reading = i;
      jumps.first = motion;
    }
  }
  return jumps;
}

/// The first scan that stands behind a reading of the odometry; the number of scans if none does.
int ScanAfter(const ScanLog& log, std::size_t reading) {
  const auto after = [reading](const LaserScan& scan) {
    return scan.num_odometry_before > static_cast<int>(reading);
  };
  return static_cast<int>(std::find_if(log.scans.begin(), log.scans.end(), after) -
                          log.scans.begin());
}

/// The scans before which odometry does what `does` asks for.
template <typename Predicate>
std::vector<int> ScansBeforeWhich(const ScanLog& log, const Predicate& does) {
  std::vector<int> scans;
  for (int scan = 1; scan < static_cast<int>(log.scans.size()); ++scan) {
    if (does(scan)) scans.push_back(scan);
  }
  return scans;
}

void AdviseOnTimes(const ScanLog& log, LogReport* report) {
  const Backwards backwards = BackwardsIn(log.scans);
  if (backwards.count > 0) {
    report->advice.push_back(
        fmt::format("{} stamps of scans run backwards, by up to {:.2f} s. The order of the file is "
                    "taken as the "
                    "true one; do not sort it.",
                    backwards.count, backwards.most));
  }
  constexpr double kLongPause = 3.0;
  if (report->longest_pause > kLongPause && report->longest_pause > 10.0 * report->scan_period) {
    report->advice.push_back(fmt::format(
        "No scan for {:.1f} s before scan {}: if the robot moved on meanwhile, the map may break "
        "there.",
        report->longest_pause, report->scan_after_pause));
  }
  if (log.scans.size() > 1 && report->duration == 0.0) {
    report->advice.push_back(
        "All scans have the same stamp: options that count in seconds mean nothing.");
  }
}

void AdviseOnJumps(const ScanLog& log, const OdometryOfScans& odometry, LogReport* report) {
  const Jumps jumps = JumpsOf(log.odometry);
  if (jumps.count > 0) {
    report->advice.push_back(fmt::format(
        "Odometry jumps {} times, first by {:.2f} m and {:.1f} deg before scan {}. A wide search "
        "(TRAJECTORY_BUILDER_2D.recovery) gets over most of them; look at `render --view match` "
        "there, and try --no-odometry.",
        jumps.count, jumps.first.translation.norm(), RadiansToDegrees(jumps.first.rotation),
        ScanAfter(log, jumps.first_reading)));
  }
  const std::vector<int> after_leaps =
      ScansBeforeWhich(log, [&](int scan) { return OdometryLeaps(odometry, scan); });
  if (!after_leaps.empty()) {
    report->advice.push_back(fmt::format(
        "Odometry leaps by 100 m or more before {} scans, first before scan {}: no robot "
        "does, and it is not used there.",
        after_leaps.size(), after_leaps.front()));
  }
}

void AdviseOnSlowness(const ScanLog& log, LogReport* report) {
  const int num_scans = NumScansPerReading(log);
  if (num_scans == 1) return;
  report->advice.push_back(fmt::format(
      "Odometry is new at one scan in {}: each motion is spread evenly over the scans since the "
      "reading before.",
      num_scans));
}

void AdviseOnHanging(const ScanLog& log, const OdometryOfScans& odometry, LogReport* report) {
  const double max_changed_share =
      LoopscopePreset().trajectory_builder_2d.max_changed_share_at_standstill;
  const std::vector<int> after_hanging = ScansBeforeWhich(
      log, [&](int scan) { return OdometryHangs(log, odometry, scan, max_changed_share); });
  if (!after_hanging.empty()) {
    report->advice.push_back(fmt::format(
        "Odometry stands still before {} scans, first before scan {}, though they see something "
        "else than those before them: it hangs. By default it is not used there "
        "(TRAJECTORY_BUILDER_2D.max_changed_share_at_standstill).",
        after_hanging.size(), after_hanging.front()));
  }
}

void AdviseOnOdometry(const ScanLog& log, LogReport* report) {
  if (log.odometry.empty()) {
    report->advice.push_back(
        "No odometry: each motion is guessed from the one before. Fast turns between scans may be "
        "lost.");
    return;
  }
  const OdometryOfScans odometry = ReadOdometryOfScans(log);
  AdviseOnJumps(log, odometry, report);
  AdviseOnSlowness(log, report);
  AdviseOnHanging(log, odometry, report);
  constexpr double kSparse = 0.5;
  if (report->scan_distance > kSparse) {
    report->advice.push_back(fmt::format(
        "Scans are {:.1f} m apart: key frames. The map hangs on the odometry between them.",
        report->scan_distance));
  }
}

void AdviseOnRanges(const ScanLog& log, LogReport* report) {
  constexpr double kMuchNothing = 0.5;
  constexpr double kMuchInvalid = 0.05;
  constexpr int kFewBeams = 60;
  if (report->share_of_nothing > kMuchNothing) {
    report->advice.push_back(fmt::format(
        "From {:.0f} % of the beams nothing came back: outdoors, or a scanner of short range. "
        "There is little to match with.",
        100.0 * report->share_of_nothing));
  }
  if (report->share_of_invalid > kMuchInvalid) {
    report->advice.push_back(
        fmt::format("{:.0f} % of the readings are invalid (zero, negative or no number) and are "
                    "dropped.",
                    100.0 * report->share_of_invalid));
  }
  const auto few = [](const BeamGeometry& beams) { return beams.num_beams < kFewBeams; };
  if (std::any_of(log.beam_geometries.begin(), log.beam_geometries.end(), few)) {
    report->advice.push_back(
        fmt::format("Scans of less than {} beams: matches are weak.", kFewBeams));
  }
}

}  // namespace

LogReport ReportOn(const ScanLog& log) {
  LogReport report;
  if (log.scans.empty()) return report;
  ReportTimes(log, &report);
  ReportWay(log, &report);
  ReportRanges(log, &report);
  AdviseOnTimes(log, &report);
  AdviseOnOdometry(log, &report);
  AdviseOnRanges(log, &report);
  return report;
}

}  // namespace loopscope
