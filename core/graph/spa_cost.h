// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// The error of eq. 5 between the poses of i and j, in metres, metres, radians:
///   e = ( t_ij - R_i^-1 (t_j - t_i), normalized(theta_ij - (theta_j - theta_i)) ).
Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j);

/// The same, turned by R_i into the global frame, which leaves its length as it is:
///   ( R_i t_ij - (t_j - t_i), normalized(theta_ij - (theta_j - theta_i)) ).
/// R_i, `global_from_i_rotation`, is given for many terms with the same i.
Eigen::Vector3d GlobalSpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                               const Eigen::Matrix2d& global_from_i_rotation,
                               const Pose2& global_from_j);

/// Squares of the weights of an error, equal in x and y: what makes the frame not matter.
struct SpaInformation {
  double translation = 0.0;  ///< [1/m^2]
  double rotation = 0.0;     ///< [1/rad^2]

  static SpaInformation OfWeights(double translation_weight, double rotation_weight) {
    return {translation_weight * translation_weight, rotation_weight * rotation_weight};
  }

  /// The weighted square of an error in either frame.
  double SquareOf(const Eigen::Vector3d& error) const {
    return translation * error.head<2>().squaredNorm() + rotation * error.z() * error.z();
  }
};

/// What a term of eq. 4 adds to H = J^T W J and g = J^T W e, where J are the derivatives of its
/// error by (x, y, theta) of i and of j. Rotations drop out, for W is the same in x and y.
struct SpaQuadratic {
  SpaQuadratic(const Eigen::Vector3d& global_error, const Pose2& global_from_i,
               const Pose2& global_from_j, const SpaInformation& information);

  Eigen::Matrix3d ii;
  Eigen::Matrix3d ji;
  Eigen::Matrix3d jj;
  Eigen::Vector3d by_i;  ///< of g
  Eigen::Vector3d by_j;
};

/// The weight by which Huber's loss of `scale` stands for a square at an error whose square is
/// `square`; both weighted, without unit.
double HuberWeight(double square, double scale);

/// Half of Huber's loss there: what such a term adds to the cost.
double HuberCost(double square, double scale);

}  // namespace loopscope
