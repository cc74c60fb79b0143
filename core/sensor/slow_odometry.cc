// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/slow_odometry.h"

#include <algorithm>

#include "core/geometry/leap.h"

namespace loopscope {
namespace {

/// Fewer motions tell nothing of how often odometry is read.
constexpr std::size_t kMinMotions = 20;

OdometryOfScans AsRead(const ScanLog& log) {
  OdometryOfScans odometry;
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    const auto reading = OdometryOfScan(log, scan);
    odometry.push_back(reading ? std::make_optional(reading->odom_from_base) : std::nullopt);
  }
  return odometry;
}

/// The scans at which odometry tells something else than at the scan before.
std::vector<int> ScansWithNews(const OdometryOfScans& odometry) {
  std::vector<int> scans;
  for (int scan = 0; scan < static_cast<int>(odometry.size()); ++scan) {
    if (odometry[scan] && (scan == 0 || odometry[scan] != odometry[scan - 1])) {
      scans.push_back(scan);
    }
  }
  return scans;
}

/// The median of the scans from one to the next: a robot that rests makes few of them long.
int NumScansPerReading(const std::vector<int>& scans_with_news) {
  if (scans_with_news.size() <= kMinMotions) return 1;
  std::vector<int> counts;
  for (std::size_t i = 1; i < scans_with_news.size(); ++i) {
    counts.push_back(scans_with_news[i] - scans_with_news[i - 1]);
  }
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle;
}

}  // namespace

int NumScansPerReading(const ScanLog& log) {
  return NumScansPerReading(ScansWithNews(AsRead(log)));
}

OdometryOfScans ReadOdometryOfScans(const ScanLog& log) {
  OdometryOfScans odometry = AsRead(log);
  const std::vector<int> news = ScansWithNews(odometry);
  const int num_scans = NumScansPerReading(news);
  for (std::size_t i = 1; i < news.size() && num_scans > 1; ++i) {
    const int first = std::max(news[i - 1], news[i] - num_scans);
    const Pose2 from = *odometry[first];
    const Pose2 to = *odometry[news[i]];
    if (IsLeap(from.Inverse() * to)) continue;
    for (int scan = first + 1; scan < news[i]; ++scan) {
      odometry[scan] = Interpolate(from, to, static_cast<double>(scan - first) / (news[i] - first));
    }
  }
  return odometry;
}

}  // namespace loopscope
