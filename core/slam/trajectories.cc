// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/trajectories.h"

#include <algorithm>

namespace loopscope {
namespace {

/// A stamp of the log, in the order of the log.
struct Waypoint {
  double time = 0.0;      ///< [s]
  Pose2 track_from_base;  ///< in the frame of what carries the poses on: odometry or local SLAM
  int node = -1;          ///< index, if this is the scan of a node
};

void SortByTime(Trajectory* trajectory) {
  std::stable_sort(trajectory->begin(), trajectory->end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
}

/// Index of the node that a step became, or -1 if it became none that `state` has.
int NodeOfStep(const Recording& recording, int step) {
  const auto& node = recording.step(step).node;
  return node ? node->index : -1;
}

std::vector<Waypoint> WaypointsOfLocalSlam(const Recording& recording, const MapState& state) {
  std::vector<Waypoint> waypoints;
  for (int step = 0; step <= state.step; ++step) {
    waypoints.push_back({recording.log().scans[step].time, recording.step(step).local_from_base,
                         NodeOfStep(recording, step)});
  }
  return waypoints;
}

/// A scan stands where the odometry before it was; if that has the same stamp, they are one.
std::vector<Waypoint> WaypointsOfOdometry(const Recording& recording, const MapState& state) {
  const ScanLog& log = recording.log();
  std::vector<Waypoint> waypoints;
  int next_reading = 0;
  const auto add_odometry_until = [&](int end) {
    for (; next_reading < end; ++next_reading) {
      const OdometryReading& reading = log.odometry[next_reading];
      waypoints.push_back({reading.time, reading.odom_from_base, -1});
    }
  };
  for (int step = 0; step <= state.step; ++step) {
    const LaserScan& scan = log.scans[step];
    add_odometry_until(scan.num_odometry_before);
    const auto before = OdometryOfScan(log, step).value_or(log.odometry.front());
    if (!waypoints.empty() && waypoints.back().time == scan.time) waypoints.pop_back();
    waypoints.push_back({scan.time, before.odom_from_base, NodeOfStep(recording, step)});
  }
  if (state.step + 1 == static_cast<int>(log.scans.size())) {
    add_odometry_until(static_cast<int>(log.odometry.size()));
  }
  return waypoints;
}

/// Carries the pose at waypoint `from` over the waypoints [begin, end).
void CarryOn(const std::vector<Waypoint>& waypoints, std::size_t from, const Pose2& map_from_node,
             std::size_t begin, std::size_t end, Trajectory* trajectory) {
  const Pose2 map_from_track = map_from_node * waypoints[from].track_from_base.Inverse();
  for (std::size_t i = begin; i < end; ++i) {
    trajectory->push_back({waypoints[i].time, map_from_track * waypoints[i].track_from_base});
  }
}

/// Moves the poses of the waypoints (from, to) by what the pose carried on to `to` has wrong.
void SpreadResidual(const std::vector<Waypoint>& waypoints, std::size_t from, std::size_t to,
                    const Pose2& carried, const Pose2& map_from_next_node, Trajectory* trajectory) {
  const Eigen::Vector2d translation = map_from_next_node.translation - carried.translation;
  const double rotation = NormalizeAngle(map_from_next_node.rotation - carried.rotation);
  const double duration = waypoints[to].time - waypoints[from].time;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double passed = waypoints[i].time - waypoints[from].time;
    const double share = duration > 0.0 ? std::clamp(passed / duration, 0.0, 1.0) : 1.0;
    Pose2& pose = (*trajectory)[i].map_from_base;
    pose = Pose2(pose.translation + share * translation,
                 NormalizeAngle(pose.rotation + share * rotation));
  }
}

std::vector<std::size_t> NodesAmong(const std::vector<Waypoint>& waypoints) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (waypoints[i].node >= 0) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace

Trajectory NodeTrajectory(const Recording& recording, const MapState& state) {
  Trajectory trajectory;
  for (int i = 0; i < state.num_nodes; ++i) {
    const double time = recording.log().scans[recording.nodes()[i].step].time;
    trajectory.push_back({time, state.global_from_node[i]});
  }
  SortByTime(&trajectory);
  return trajectory;
}

Trajectory DenseTrajectory(const Recording& recording, const MapState& state) {
  const bool has_odometry =
      !recording.log().odometry.empty() && recording.options().trajectory_builder_2d.use_odometry;
  const std::vector<Waypoint> waypoints =
      has_odometry ? WaypointsOfOdometry(recording, state) : WaypointsOfLocalSlam(recording, state);
  const std::vector<std::size_t> nodes = NodesAmong(waypoints);
  Trajectory trajectory;
  if (nodes.empty()) return trajectory;
  const auto pose_of = [&](std::size_t i) {
    return state.global_from_node[waypoints[nodes[i]].node];
  };
  CarryOn(waypoints, nodes[0], pose_of(0), 0, nodes[0], &trajectory);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t end = i + 1 < nodes.size() ? nodes[i + 1] : waypoints.size();
    CarryOn(waypoints, nodes[i], pose_of(i), nodes[i], end, &trajectory);
    if (end == waypoints.size()) break;
    const Pose2 carried = pose_of(i) * (waypoints[nodes[i]].track_from_base.Inverse() *
                                        waypoints[end].track_from_base);
    SpreadResidual(waypoints, nodes[i], end, carried, pose_of(i + 1), &trajectory);
  }
  SortByTime(&trajectory);
  return trajectory;
}

}  // namespace loopscope
