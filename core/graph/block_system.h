// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/graph/block_cholesky.h"

namespace loopscope {

/// A symmetric, positive definite system of linear equations, of 3 x 3 blocks, few of which are not
/// zero.
class BlockSystem {
 public:
  /// Two unknowns with a block of their own off the diagonal: row > column.
  using Coupling = BlockCholesky::Place;

  /// `couplings` are all different.
  BlockSystem(int num_unknowns, std::vector<Coupling> couplings);

  void SetZero();
  Eigen::Matrix3d& diagonal(int unknown) { return diagonal_[unknown]; }
  /// The block of a coupling, by its index.
  Eigen::Matrix3d& coupling(int index) { return blocks_[index]; }

  /// Factorizes the matrix with `damping` added to its diagonal, three numbers for each unknown.
  /// Whether it is positive definite.
  bool Factorize(const Eigen::VectorXd& damping) {
    return cholesky_.Factorize(diagonal_, damping, blocks_);
  }

  /// The solution for the right-hand side `right`, three numbers for each unknown. Factorize must
  /// have succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const { return cholesky_.Solve(right); }

  /// The matrix, without damping, times `vector`.
  Eigen::VectorXd Multiply(const Eigen::VectorXd& vector) const;

 private:
  std::vector<Coupling> couplings_;
  std::vector<Eigen::Matrix3d> diagonal_;
  std::vector<Eigen::Matrix3d> blocks_;
  BlockCholesky cholesky_;
};

}  // namespace loopscope
