// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace loopscope {
namespace {

double Heading(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

// What the robot is heading for, and how fast it may be when it arrives.
struct Target {
  Eigen::Vector2d waypoint;
  double speed;  // [m/s]
};

class Driver {
 public:
  Driver(const std::vector<Eigen::Vector2d>& route, const DriveOptions& options)
      : options_(options), pose_(route[0], Heading(route[0], route[1])) {
    for (size_t i = 1; i < route.size(); ++i) {
      double speed = 0.0;
      if (i + 1 < route.size()) {
        const double turn =
            NormalizeAngle(Heading(route[i], route[i + 1]) - Heading(route[i - 1], route[i]));
        speed = options.max_speed * SpeedShare(turn);
      }
      targets_.push_back({route[i], speed});
    }
  }

  const Pose2& pose() const { return pose_; }
  bool arrived() const { return next_ == targets_.size(); }

  void Advance(double dt) {
    const Target& target = targets_[next_];
    const double distance = (target.waypoint - pose_.translation).norm();
    const double error =
        NormalizeAngle(Heading(pose_.translation, target.waypoint) - pose_.rotation);
    Accelerate(WantedSpeed(target, distance, error), WantedTurnRate(error), dt);
    // Exact for a constant turn rate up to third order in dt.
    const Pose2 old_from_new(speed_ * dt * std::cos(turn_rate_ * dt / 2.0),
                             speed_ * dt * std::sin(turn_rate_ * dt / 2.0), turn_rate_ * dt);
    pose_ = pose_ * old_from_new;
    const bool last = next_ + 1 == targets_.size();
    if (distance < (last ? kStopDistance : options_.reach)) ++next_;
  }

 private:
  static constexpr double kStopDistance = 0.05;  // [m]
  static constexpr double kCreepSpeed = 0.05;    // [m/s] so that the last waypoint is reached

  // Share of the full speed that is fit for turning by `angle` [rad]: none from 60 degrees on.
  static double SpeedShare(double angle) {
    return std::max(0.0, 1.0 - std::abs(angle) / DegreesToRadians(60.0));
  }

  double WantedSpeed(const Target& target, double distance, double error) const {
    const double braking = std::sqrt(target.speed * target.speed +
                                     2.0 * options_.acceleration * std::max(0.0, distance - 0.1));
    return std::min(options_.max_speed * SpeedShare(error), std::max(kCreepSpeed, braking));
  }

  double WantedTurnRate(double error) const {
    const double braking = std::sqrt(options_.turn_acceleration * std::abs(error));
    const double settling = 4.0 * std::abs(error);
    return std::copysign(std::min({options_.max_turn_rate, braking, settling}), error);
  }

  void Accelerate(double wanted_speed, double wanted_turn_rate, double dt) {
    const double speed_step = options_.acceleration * dt;
    const double turn_step = options_.turn_acceleration * dt;
    speed_ += std::clamp(wanted_speed - speed_, -speed_step, speed_step);
    turn_rate_ += std::clamp(wanted_turn_rate - turn_rate_, -turn_step, turn_step);
  }

  DriveOptions options_;
  std::vector<Target> targets_;
  size_t next_ = 0;  // index into targets_
  Pose2 pose_;
  double speed_ = 0.0;
  double turn_rate_ = 0.0;
};

}  // namespace

Trajectory Drive(const std::vector<Eigen::Vector2d>& route, const DriveOptions& options,
                 double period) {
  assert(route.size() >= 2 && period > 0.0);
  const int steps_per_pose = std::max(1, static_cast<int>(std::ceil(period / 0.01)));
  Driver driver(route, options);
  Trajectory trajectory{{0.0, driver.pose()}};
  while (!driver.arrived()) {
    for (int i = 0; i < steps_per_pose && !driver.arrived(); ++i) {
      driver.Advance(period / steps_per_pose);
    }
    trajectory.push_back({trajectory.size() * period, driver.pose()});
  }
  return trajectory;
}

}  // namespace loopscope
