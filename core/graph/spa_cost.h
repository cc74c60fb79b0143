// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// The error of eq. 5 between the poses of i and j, in metres, metres, radians:
///   e = ( t_ij - R_i^-1 (t_j - t_i), normalized(theta_ij - (theta_j - theta_i)) ).
Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j);
/// The same, given R_i^-1, for many terms with the same i.
Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Eigen::Matrix2d& i_from_global, const Pose2& global_from_j);

/// How the error changes with (x, y, theta) of either pose.
struct SpaDerivatives {
  Eigen::Matrix3d by_i;
  Eigen::Matrix3d by_j;
};
/// `i_from_global` is R_i^-1.
SpaDerivatives DerivativesOfSpaError(const Pose2& global_from_i,
                                     const Eigen::Matrix2d& i_from_global,
                                     const Pose2& global_from_j);

/// The weight by which Huber's loss of `scale` stands for a square at an error whose square is
/// `square`; both weighted, without unit.
double HuberWeight(double square, double scale);

}  // namespace loopscope
