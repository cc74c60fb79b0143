// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/report_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/slam/loop_explanation.h"
#include "core/slam/option_values.h"
#include "render/number_text.h"

namespace loopscope {
namespace {

/// An option in a few digits: 0.3491 for 0.3490658503988659, which is 20 degrees.
ReportRow OptionValueRow(const OptionRow& row) {
  const OptionValue value = GetValue(row);
  const std::string unit = row.unit.empty() ? "" : " " + row.unit;
  const std::string exact = ToText(value) + unit;
  const auto* const number = std::get_if<double>(&value);
  const std::string rounded = number == nullptr ? exact : fmt::format("{:.4g}", *number) + unit;
  return {row.key, rounded.size() < exact.size() ? rounded : exact, "", true, exact};
}

}  // namespace

ReportRow Row(std::string name, std::string value) {
  return {std::move(name), std::move(value), "", true};
}

std::string PoseText(const Pose2& pose) {
  return FixedText(pose.x(), 3) + " m, " + FixedText(pose.y(), 3) + " m, " +
         FixedText(RadiansToDegrees(pose.rotation), 2) + " deg";
}

std::string DifferenceText(const Pose2& a, const Pose2& b) {
  const Pose2 a_from_b = a.Inverse() * b;
  return ResidualText({a_from_b.x(), a_from_b.y(), a_from_b.rotation});
}

std::string ResidualText(const Eigen::Vector3d& residual) {
  return fmt::format("{:.3f} m, {:.2f} deg", residual.head<2>().norm(),
                     RadiansToDegrees(std::abs(residual.z())));
}

std::string TimeText(const Recording& recording, int step) {
  const auto& scans = recording.log().scans;
  return fmt::format("{:.2f} s", scans[step].time - scans.front().time);
}

Section MatchedPoses(const Recording& recording, int step) {
  const Step& record = recording.step(step);
  Section section{"Scan match (local frame)", {}};
  section.rows.push_back(Row("predicted", PoseText(record.local_from_base_prior)));
  if (record.local_from_base_correlative) {
    section.rows.push_back(
        Row("correlative matcher", PoseText(*record.local_from_base_correlative)));
  }
  section.rows.push_back(Row("matched", PoseText(record.local_from_base)));
  if (record.match_start) {
    section.rows.push_back(Row("match began", ToString(*record.match_start)));
  }
  section.rows.push_back(Row("moved by the match",
                             DifferenceText(record.local_from_base_prior, record.local_from_base)));
  if (const auto reading = OdometryOfScan(recording.log(), step)) {
    section.rows.push_back(Row("odometry (odom frame)", PoseText(reading->odom_from_base)));
  }
  return section;
}

std::vector<ReportRow> VerdictCounts(const Recording& recording, const MapState& state,
                                     const std::function<bool(const LoopCandidate&)>& wanted) {
  std::map<Verdict, int> counts;
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (wanted(candidate)) ++counts[candidate.verdict];
  }
  std::vector<ReportRow> rows;
  for (const Verdict verdict : kRecordedVerdicts) {
    rows.push_back(Row(ToString(verdict), std::to_string(counts[verdict])));
  }
  return rows;
}

Section OptionsInForce(const Options& options, const std::vector<std::string>& prefixes) {
  Options copy = options;
  Section section{"Options in force", {}};
  for (const OptionRow& row : OptionTable(&copy)) {
    const bool wanted = std::any_of(
        prefixes.begin(), prefixes.end(),
        [&](const std::string& prefix) { return row.key.compare(0, prefix.size(), prefix) == 0; });
    if (!wanted) continue;
    section.rows.push_back(OptionValueRow(row));
  }
  return section;
}

}  // namespace loopscope
