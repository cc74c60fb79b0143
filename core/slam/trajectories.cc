// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/trajectories.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace loopscope {
namespace {

/// What of the log has a stamp, in the order of the log.
struct Waypoint {
  double time = 0.0;                   ///< [s]
  Pose2 track_from_base;               ///< as local SLAM or odometry tracks the robot
  std::optional<Pose2> map_from_base;  ///< where it is known
};

void SortByTime(Trajectory* trajectory) {
  std::stable_sort(trajectory->begin(), trajectory->end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
}

/// Of all scans; known are the nodes.
std::vector<Waypoint> WaypointsOfLocalSlam(const Recording& recording, const MapState& state) {
  std::vector<Waypoint> waypoints;
  for (int i = 0; i <= state.step; ++i) {
    const Step& step = recording.step(i);
    waypoints.push_back({recording.log().scans[i].time, step.local_from_base, std::nullopt});
    if (step.node) waypoints.back().map_from_base = state.global_from_node[step.node->index];
  }
  return waypoints;
}

/// Of all odometry; known are the `scans` of the log. A scan stands where the odometry before it
/// was; if that has the same stamp, they are one.
std::vector<Waypoint> WaypointsOfOdometry(const ScanLog& log, const Trajectory& scans) {
  std::vector<Waypoint> waypoints;
  std::size_t next_reading = 0;
  const auto add_odometry_until = [&](std::size_t end) {
    for (; next_reading < end; ++next_reading) {
      const OdometryReading& reading = log.odometry[next_reading];
      waypoints.push_back({reading.time, reading.odom_from_base, std::nullopt});
    }
  };
  for (std::size_t i = 0; i < scans.size(); ++i) {
    add_odometry_until(log.scans[i].num_odometry_before);
    const auto before = OdometryOfScan(log, static_cast<int>(i)).value_or(log.odometry.front());
    if (!waypoints.empty() && waypoints.back().time == scans[i].time) waypoints.pop_back();
    waypoints.push_back({scans[i].time, before.odom_from_base, scans[i].map_from_base});
  }
  if (scans.size() == log.scans.size()) add_odometry_until(log.odometry.size());
  return waypoints;
}

/// Whether the track jumped: `carried` is farther from where the robot is known to have come than
/// the way there, or turned more than it turned.
bool Contradicts(const Pose2& carried, const Pose2& known_before, const Pose2& known) {
  constexpr double kSlack = 0.1;  // [m], [rad]
  const auto away = [&](const Pose2& pose) { return known.Inverse() * pose; };
  const Pose2 residual = away(carried);
  const Pose2 motion = away(known_before);
  return residual.translation.norm() > motion.translation.norm() + kSlack ||
         std::abs(residual.rotation) > std::abs(motion.rotation) + kSlack;
}

/// The poses between two known ones, in equal steps.
void InterpolateBetween(std::size_t from, std::size_t to, Trajectory* trajectory) {
  const Pose2 first = (*trajectory)[from].map_from_base;
  const Pose2 last = (*trajectory)[to].map_from_base;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = static_cast<double>(i - from) / static_cast<double>(to - from);
    (*trajectory)[i].map_from_base = Interpolate(first, last, share);
  }
}

/// Adds to the poses between two known ones what the first, carried on to the second, has wrong:
/// to each an equal part more, for readings come at a steadier pace than the stamps of some logs.
void SpreadResidual(const Pose2& carried, const Pose2& known, std::size_t from, std::size_t to,
                    Trajectory* trajectory) {
  const Eigen::Vector2d translation = known.translation - carried.translation;
  const double rotation = NormalizeAngle(known.rotation - carried.rotation);
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = static_cast<double>(i - from) / static_cast<double>(to - from);
    Pose2& pose = (*trajectory)[i].map_from_base;
    pose = Pose2(pose.translation + share * translation,
                 NormalizeAngle(pose.rotation + share * rotation));
  }
}

/// The poses of all waypoints: the known ones, carried on along the track. Empty if none is known.
Trajectory CarryOn(const std::vector<Waypoint>& waypoints) {
  const auto is_known = [](const Waypoint& waypoint) { return waypoint.map_from_base.has_value(); };
  const auto first = std::find_if(waypoints.begin(), waypoints.end(), is_known);
  if (first == waypoints.end()) return {};
  auto known = static_cast<std::size_t>(first - waypoints.begin());
  Trajectory trajectory;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const Pose2 carried =
        *waypoints[known].map_from_base *
        (waypoints[known].track_from_base.Inverse() * waypoints[i].track_from_base);
    if (i <= known || !is_known(waypoints[i])) {
      trajectory.push_back({waypoints[i].time, carried});
      continue;
    }
    trajectory.push_back({waypoints[i].time, *waypoints[i].map_from_base});
    if (Contradicts(carried, *waypoints[known].map_from_base, *waypoints[i].map_from_base)) {
      InterpolateBetween(known, i, &trajectory);
    } else {
      SpreadResidual(carried, *waypoints[i].map_from_base, known, i, &trajectory);
    }
    known = i;
  }
  return trajectory;
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
  const ScanLog& log = recording.log();
  Trajectory trajectory = CarryOn(WaypointsOfLocalSlam(recording, state));
  if (!trajectory.empty() && !log.odometry.empty() &&
      recording.options().trajectory_builder_2d.use_odometry) {
    trajectory = CarryOn(WaypointsOfOdometry(log, trajectory));
  }
  SortByTime(&trajectory);
  return trajectory;
}

}  // namespace loopscope
