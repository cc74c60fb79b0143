// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "app/session/inspection_report.h"
#include "app/session/report_rows.h"
#include "core/slam/covariance.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

/// `covariance` is in [m, m, rad].
Section CovarianceSection(const std::optional<Eigen::Matrix3d>& covariance) {
  Section section{"Uncertainty (global frame, against submap (0, 0))", {}};
  if (!covariance) {
    section.rows = {Row("standard deviations", "the graph does not determine this pose")};
    return section;
  }
  const Eigen::Vector3d deviations = covariance->diagonal().cwiseSqrt();
  section.rows = {Row("standard deviation of x", fmt::format("{:.4f} m", deviations.x())),
                  Row("standard deviation of y", fmt::format("{:.4f} m", deviations.y())),
                  Row("standard deviation of heading",
                      fmt::format("{:.4f} deg", RadiansToDegrees(deviations.z())))};
  const double product = deviations.x() * deviations.y();
  if (product > 0.0) {
    section.rows.push_back(
        Row("correlation of x and y", fmt::format("{:.2f}", (*covariance)(0, 1) / product)));
  }
  return section;
}

void RequireInState(bool exists, const std::string& what, const MapState& state) {
  if (exists) return;
  throw std::invalid_argument(
      fmt::format("there is no {} at step {}; expected one that has a pose", what, state.step));
}

}  // namespace

Section ReportOnCovariance(const Recording& recording, const MapState& state, NodeId node) {
  RequireNode(recording, node);
  RequireInState(node.index < state.num_nodes, "node " + ToString(node), state);
  return CovarianceSection(CovarianceOfNode(recording, state, node));
}

Section ReportOnCovariance(const Recording& recording, const MapState& state, SubmapId submap) {
  RequireSubmap(recording, submap);
  RequireInState(submap.index < state.num_submaps, "submap " + ToString(submap), state);
  return CovarianceSection(CovarianceOfSubmap(recording, state, submap));
}

}  // namespace loopscope
