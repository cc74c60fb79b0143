// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/hanging_odometry.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

constexpr int kMinNumBeams = 30;

bool IsFromElsewhere(float before, float now) {
  return std::abs(now - before) > std::max(0.1F, 0.02F * now);
}

}  // namespace

double ShareOfChangedRanges(const LaserScan& before, const LaserScan& now) {
  if (before.beam_geometry != now.beam_geometry) return 0.0;
  int num_beams = 0;
  int num_changed = 0;
  for (std::size_t i = 0; i < now.ranges.size(); ++i) {
    if (!std::isfinite(before.ranges[i]) || !std::isfinite(now.ranges[i])) continue;
    ++num_beams;
    if (IsFromElsewhere(before.ranges[i], now.ranges[i])) ++num_changed;
  }
  return num_beams < kMinNumBeams ? 0.0 : num_changed / static_cast<double>(num_beams);
}

bool OdometryHangs(const ScanLog& log, int scan, double max_changed_share) {
  if (scan == 0) return false;
  const auto before = OdometryOfScan(log, scan - 1);
  const auto now = OdometryOfScan(log, scan);
  return before && now && before->odom_from_base == now->odom_from_base &&
         ShareOfChangedRanges(log.scans[scan - 1], log.scans[scan]) > max_changed_share;
}

}  // namespace loopscope
