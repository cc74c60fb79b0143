// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace loopscope {

/// The angle that differs from `radians` by whole turns and lies in (-pi, pi].
double NormalizeAngle(double radians);

constexpr double DegreesToRadians(double degrees) { return degrees * 0.017453292519943295; }
constexpr double RadiansToDegrees(double radians) { return radians * 57.29577951308232; }

/// A pose or transform in SE(2), T_xi of the paper (eq. 1). A variable is named
/// `target_from_source`: it takes points of the source frame to the target frame, and is also the
/// pose of the source frame's origin in the target frame.
struct Pose2 {
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< [m]
  double rotation = 0.0;                                  ///< [rad], counter-clockwise

  Pose2() = default;
  Pose2(const Eigen::Vector2d& translation, double rotation)
      : translation(translation), rotation(rotation) {}
  Pose2(double x, double y, double rotation) : translation(x, y), rotation(rotation) {}

  double x() const { return translation.x(); }
  double y() const { return translation.y(); }

  Eigen::Matrix2d RotationMatrix() const;
  Pose2 Inverse() const;
};

/// c_from_b * b_from_a = c_from_a. The rotation is normalized to (-pi, pi].
Pose2 operator*(const Pose2& c_from_b, const Pose2& b_from_a);

/// target_from_source * point_in_source = point_in_target.
Eigen::Vector2d operator*(const Pose2& target_from_source, const Eigen::Vector2d& point_in_source);

bool operator==(const Pose2& a, const Pose2& b);
inline bool operator!=(const Pose2& a, const Pose2& b) { return !(a == b); }

/// [m] A map reaches so far from its origin, in x and in y. Cells of 5 mm can be counted so far.
constexpr double kMaxMapCoordinate = 1e6;

/// Whether a map can hold the pose: it is a number, and not beyond.
bool IsInMap(const Pose2& pose);

/// `value` with six decimals. What is recorded is rounded so: no measurement is as exact, and the
/// rest would be noise that takes most of the space.
double Rounded(double value);
/// Likewise, in micrometres and microradians.
Pose2 Rounded(const Pose2& pose);

/// The pose a share `t` in [0, 1] of the way from `a` to `b`, turning the shorter way.
Pose2 Interpolate(const Pose2& a, const Pose2& b, double t);

}  // namespace loopscope
