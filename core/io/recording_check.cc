// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_check.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

using Fault = std::optional<std::string>;

/// Whether 0 <= index < size.
bool Within(int index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

bool IsFinite(const Pose2& pose) {
  return pose.translation.allFinite() && std::isfinite(pose.rotation);
}

bool IsWithin(double value, double low, double high) { return low <= value && value <= high; }

bool AllInMap(const std::vector<Pose2>& poses) {
  return std::all_of(poses.begin(), poses.end(), IsInMap);
}

/// The submaps of a node are the last ones, which have held all nodes since their first.
Fault FaultOf(const Node& node, const std::optional<Submap>& started, const Recording& recording) {
  const auto& submaps = recording.submaps();
  const int num_nodes = static_cast<int>(recording.nodes().size());
  const std::size_t num_submaps = submaps.size() + (started ? 1 : 0);
  if (node.step != recording.num_steps()) return "a node of another step";
  if (!IsInMap(node.local_from_base)) return "a node whose pose is nowhere";
  if (node.num_submaps < 1 || node.num_submaps > 2 ||
      !Within(node.first_submap.index, num_submaps)) {
    return "a node in submaps that are not there";
  }
  if (static_cast<std::size_t>(node.first_submap.index) + node.num_submaps != num_submaps) {
    return "a node that is not in the last submaps";
  }
  for (int i = 0; i < node.num_submaps; ++i) {
    const std::size_t index = static_cast<std::size_t>(node.first_submap.index + i);
    const Submap& submap = index < submaps.size() ? submaps[index] : *started;
    if (submap.finished_step >= 0) return "a node in a finished submap";
    if (submap.first_node.index + submap.num_nodes != num_nodes) {
      return "a node in a submap that misses some before it";
    }
  }
  return std::nullopt;
}

Fault FaultOf(const Submap& submap) {
  return IsInMap(submap.local_from_submap) ? std::nullopt : Fault("a submap whose pose is nowhere");
}

/// Of the pair, which must have been there when it came up.
Fault FaultOfPair(const LoopCandidate& candidate, const SlamUpdate& update,
                  const Recording& recording) {
  const int step = recording.num_steps();
  const std::size_t num_nodes = recording.nodes().size();
  const std::size_t num_submaps = recording.submaps().size();
  if (!Within(candidate.submap.index, num_submaps + (update.started_submap ? 1 : 0))) {
    return "a loop to a submap that is not there";
  }
  if (!Within(candidate.node.index, num_nodes + (update.node ? 1 : 0))) {
    return "a loop to a node that is not there";
  }
  const auto step_of_node = [&](NodeId node) {
    return Within(node.index, num_nodes) ? recording.node(node).step : step;
  };
  const int step_of_submap = Within(candidate.submap.index, num_submaps)
                                 ? step_of_node(recording.submap(candidate.submap).first_node)
                                 : step;
  if (candidate.considered_step < std::max(step_of_node(candidate.node), step_of_submap)) {
    return "a loop from a step before its node or submap";
  }
  if (candidate.considered_step > step) return "a loop from a later step";
  return std::nullopt;
}

Fault FaultOfSearch(const LoopCandidate& candidate, const ConstraintBuilderOptions& options) {
  constexpr double kRounding = 1e-6;
  if (!IsWithin(candidate.linear_search_window, 0.0, MaxLinearWindow(options) + kRounding) ||
      !IsWithin(candidate.angular_search_window, 0.0, M_PI + kRounding)) {
    return "a loop whose search window is larger than the options allow";
  }
  for (const double score :
       {candidate.score, candidate.score_bound, candidate.min_score, candidate.rival_score}) {
    if (!std::isfinite(score)) return "a loop whose score is not finite";
  }
  if (!IsInMap(candidate.submap_from_node_guess) || !IsInMap(candidate.submap_from_node_searched) ||
      !IsInMap(candidate.submap_from_node)) {
    return "a loop whose pose is nowhere";
  }
  return std::nullopt;
}

Fault FaultOf(const Optimization& optimization, std::size_t num_submaps, std::size_t num_nodes) {
  if (num_nodes == 0) return "an optimization before the first node";
  if (optimization.global_from_submap.size() != num_submaps ||
      optimization.global_from_node.size() != num_nodes) {
    return "an optimization with a wrong number of poses";
  }
  if (!AllInMap(optimization.global_from_submap) || !AllInMap(optimization.global_from_node)) {
    return "an optimization with poses that are nowhere";
  }
  if (!IsWithin(optimization.drift_share.linear, 0.0, 1.0) ||
      !IsWithin(optimization.drift_share.angular, 0.0, 1.0)) {
    return "an optimization with a share of windows that is not between 0 and 1";
  }
  constexpr double kMaxCost = 1e100;
  if (!IsWithin(optimization.initial_cost, -kMaxCost, kMaxCost) ||
      !IsWithin(optimization.final_cost, -kMaxCost, kMaxCost)) {
    return "an optimization whose cost makes no sense";
  }
  return std::nullopt;
}

}  // namespace

Fault FaultOf(const ScanLog& log) {
  if (!IsFinite(log.base_from_laser)) return "a scanner whose pose is not finite";
  for (const BeamGeometry& beams : log.beam_geometries) {
    if (!std::isfinite(beams.first_angle) || !std::isfinite(beams.angle_increment)) {
      return "beams whose angles are not finite";
    }
  }
  for (const OdometryReading& reading : log.odometry) {
    if (!std::isfinite(reading.time) || !IsFinite(reading.odom_from_base)) {
      return "odometry that is not finite";
    }
  }
  int last_num_odometry = 0;
  for (const LaserScan& scan : log.scans) {
    if (!std::isfinite(scan.time)) return "a scan whose time is not finite";
    if (!Within(scan.beam_geometry, log.beam_geometries.size())) return "a scan without beams";
    if (static_cast<int>(scan.ranges.size()) != log.beam_geometries[scan.beam_geometry].num_beams) {
      return "a scan with a wrong number of ranges";
    }
    if (scan.num_odometry_before < last_num_odometry ||
        scan.num_odometry_before > static_cast<int>(log.odometry.size())) {
      return "a scan amid odometry that is not there";
    }
    last_num_odometry = scan.num_odometry_before;
  }
  return std::nullopt;
}

Fault FaultOf(const SlamUpdate& update, const Recording& recording) {
  const int step = recording.num_steps();
  const std::size_t num_submaps = recording.submaps().size() + (update.started_submap ? 1 : 0);
  const std::size_t num_nodes = recording.nodes().size() + (update.node ? 1 : 0);
  if (!Within(step, recording.log().scans.size())) return "more steps than scans";
  const Step& record = update.step;
  if (!IsFinite(record.local_from_base) || !IsFinite(record.local_from_base_prior) ||
      (record.local_from_base_correlative && !IsFinite(*record.local_from_base_correlative))) {
    return "a pose that is not finite";
  }
  if (update.started_submap) {
    if (!update.node) return "a submap without a node";
    if (Fault fault = FaultOf(*update.started_submap)) return fault;
  }
  if (update.node) {
    if (Fault fault = FaultOf(*update.node, update.started_submap, recording)) return fault;
  }
  if (update.finished_submap && !Within(update.finished_submap->index, num_submaps)) {
    return "a finished submap that is not there";
  }
  for (const LoopCandidate& candidate : update.candidates) {
    if (Fault fault = FaultOfPair(candidate, update, recording)) return fault;
    if (Fault fault = FaultOfSearch(candidate, recording.options().pose_graph.constraint_builder)) {
      return fault;
    }
  }
  if (update.optimization) return FaultOf(*update.optimization, num_submaps, num_nodes);
  return std::nullopt;
}

}  // namespace loopscope
