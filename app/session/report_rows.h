// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/inspection_report.h"
#include "core/slam/options.h"

namespace loopscope {

// What several inspection reports have in common.

/// A row without a gate.
ReportRow Row(std::string name, std::string value);

/// "1.234 m, -5.678 m, 12.34 deg".
std::string PoseText(const Pose2& pose);

/// How far apart two poses are: "0.123 m, 1.23 deg".
std::string DifferenceText(const Pose2& a, const Pose2& b);

/// A residual [m, m, rad]: "0.123 m, 1.23 deg".
std::string ResidualText(const Eigen::Vector3d& residual);

/// Time of a scan since the first one of the log: "12.34 s".
std::string TimeText(const Recording& recording, int step);

/// Where the scan of a step was predicted, where it was matched, and how far that moved it.
Section MatchedPoses(const Recording& recording, int step);

/// Number of candidates of every verdict among those that were applied by `state` and are
/// `wanted`.
std::vector<ReportRow> VerdictCounts(const Recording& recording, const MapState& state,
                                     const std::function<bool(const LoopCandidate&)>& wanted);

/// The options whose keys begin with one of `prefixes`.
Section OptionsInForce(const Options& options, const std::vector<std::string>& prefixes);

}  // namespace loopscope
