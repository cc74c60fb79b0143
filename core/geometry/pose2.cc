// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/pose2.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

double NormalizeAngle(double radians) {
  if (-M_PI < radians && radians <= M_PI) return radians;     // nearly always; a remainder is slow
  const double folded = std::remainder(radians, 2.0 * M_PI);  // in [-pi, pi]
  return folded == -M_PI ? M_PI : folded;
}

Eigen::Matrix2d Pose2::RotationMatrix() const {
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

Pose2 Pose2::Inverse() const {
  return Pose2(-(RotationMatrix().transpose() * translation), NormalizeAngle(-rotation));
}

Pose2 operator*(const Pose2& c_from_b, const Pose2& b_from_a) {
  return Pose2(c_from_b * b_from_a.translation,
               NormalizeAngle(c_from_b.rotation + b_from_a.rotation));
}

Eigen::Vector2d operator*(const Pose2& target_from_source, const Eigen::Vector2d& point_in_source) {
  return target_from_source.RotationMatrix() * point_in_source + target_from_source.translation;
}

bool operator==(const Pose2& a, const Pose2& b) {
  return a.translation == b.translation && a.rotation == b.rotation;
}

bool IsInMap(const Pose2& pose) {
  return std::isfinite(pose.rotation) && std::abs(pose.x()) <= kMaxMapCoordinate &&
         std::abs(pose.y()) <= kMaxMapCoordinate;
}

double Rounded(double value) { return std::round(1e6 * value) / 1e6; }

Pose2 Rounded(const Pose2& pose) {
  constexpr double kMaxRotation = 3.141592;  // pi would be rounded up
  return {Rounded(pose.x()), Rounded(pose.y()),
          std::clamp(Rounded(pose.rotation), -kMaxRotation, kMaxRotation)};
}

Pose2 Interpolate(const Pose2& a, const Pose2& b, double t) {
  return Pose2(a.translation + t * (b.translation - a.translation),
               NormalizeAngle(a.rotation + t * NormalizeAngle(b.rotation - a.rotation)));
}

}  // namespace loopscope
