// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ceres_scan_match.h"

#include <cmath>

#include <ceres/ceres.h>
#include <ceres/cubic_interpolation.h>

namespace loopscope {
namespace {

/// The cells as Ceres asks for them.
struct Cells {
  enum { DATA_DIMENSION = 1 };
  void GetValue(int row, int column, double* value) const {
    *value = grid.probability({column, row});
  }
  const ProbabilityGrid& grid;
};

struct OccupiedSpace {
  template <typename T>
  bool operator()(const T* pose, T* residuals) const {
    const ceres::BiCubicInterpolator<Cells> smooth(cells);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const T x = cos(pose[2]) * points[k].x() - sin(pose[2]) * points[k].y() + pose[0];
      const T y = sin(pose[2]) * points[k].x() + cos(pose[2]) * points[k].y() + pose[1];
      smooth.Evaluate(y / cells.grid.resolution(), x / cells.grid.resolution(), &residuals[k]);
      residuals[k] = weight * (1.0 - residuals[k]);
    }
    return true;
  }
  const PointCloud& points;
  Cells cells;
  double weight;
};

struct Prior {
  template <typename T>
  bool operator()(const T* pose, T* residuals) const {
    for (int i = 0; i < 3; ++i) residuals[i] = weights[i] * (pose[i] - target[i]);
    return true;
  }
  Eigen::Vector3d target;
  Eigen::Vector3d weights;
};

}  // namespace

RefinedMatch MatchWithAutomaticDerivatives(const PointCloud& points_in_scan,
                                           const ProbabilityGrid& grid,
                                           const Eigen::Vector2d& target_translation,
                                           const Pose2& submap_from_scan_start,
                                           const CeresScanMatcherOptions& options) {
  const int num_points = static_cast<int>(points_in_scan.size());
  Eigen::Vector3d pose(submap_from_scan_start.x(), submap_from_scan_start.y(),
                       submap_from_scan_start.rotation);
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<OccupiedSpace, ceres::DYNAMIC, 3>(
          new OccupiedSpace{points_in_scan,
                            {grid},
                            options.occupied_space_weight / std::sqrt(double(num_points))},
          num_points),
      nullptr, pose.data());
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Prior, 3, 3>(new Prior{
          {target_translation.x(), target_translation.y(), submap_from_scan_start.rotation},
          {options.translation_weight, options.translation_weight, options.rotation_weight}}),
      nullptr, pose.data());
  ceres::Solver::Options solver_options;
  solver_options.linear_solver_type = ceres::DENSE_QR;
  solver_options.max_num_iterations = options.max_num_iterations;
  solver_options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options, &problem, &summary);
  return {Pose2(pose.x(), pose.y(), NormalizeAngle(pose.z())), summary.initial_cost,
          summary.final_cost, static_cast<int>(summary.iterations.size())};
}

}  // namespace loopscope
