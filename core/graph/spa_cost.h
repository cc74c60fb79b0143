// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <ceres/cost_function.h>

#include "core/geometry/pose2.h"

namespace loopscope {

/// The error of eq. 5 between the poses of i and j, weighted:
///   e = ( w_t (t_ij - R_i^-1 (t_j - t_i)), w_r normalized(theta_ij - (theta_j - theta_i)) ).
/// Two parameter blocks (x, y, theta): global_from_i, global_from_j; analytic derivatives.
std::unique_ptr<ceres::CostFunction> MakeSpaCost(const Pose2& i_from_j, double translation_weight,
                                                 double rotation_weight);

/// The error without weights: metres, metres, radians.
Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j);

}  // namespace loopscope
