// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/changed_ranges.h"

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

bool ShowsAnotherPlace(const ScanLog& log, int scan) {
  constexpr double kMinChangedShare = 0.4;
  return scan > 0 && ShareOfChangedRanges(log.scans[scan - 1], log.scans[scan]) > kMinChangedShare;
}

}  // namespace loopscope
