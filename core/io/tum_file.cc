// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/tum_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/io/number_rows.h"
#include "core/io/replace_file.h"

namespace loopscope {
namespace {

/// Relations have eight numbers a line, too.
bool HasUnitQuaternion(const NumberRow& row) {
  constexpr double kMaxRounding = 1e-2;
  const double square = row[4] * row[4] + row[5] * row[5] + row[6] * row[6] + row[7] * row[7];
  return std::abs(std::sqrt(square) - 1.0) < kMaxRounding;
}

}  // namespace

Trajectory ReadTum(const std::string& path) {
  Trajectory trajectory;
  const RowCondition condition{HasUnitQuaternion, "qx qy qz qw to be of length 1"};
  for (const NumberRow& row : ReadNumberRows(path, "time x y z qx qy qz qw", condition)) {
    const double x = row[4], y = row[5], z = row[6], w = row[7];
    const double yaw = std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
    trajectory.push_back({row[0], Pose2(row[1], row[2], yaw)});
  }
  std::stable_sort(trajectory.begin(), trajectory.end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
  return trajectory;
}

void WriteTum(const std::string& path, const Trajectory& trajectory) {
  std::string text = "# time x y z qx qy qz qw\n";
  for (const auto& [time, pose] : trajectory) {
    fmt::format_to(std::back_inserter(text), "{:.9f} {:.9f} {:.9f} 0 0 0 {:.12f} {:.12f}\n", time,
                   pose.x(), pose.y(), std::sin(pose.rotation / 2.0),
                   std::cos(pose.rotation / 2.0));
  }
  ReplaceFile(path, text);
}

}  // namespace loopscope
