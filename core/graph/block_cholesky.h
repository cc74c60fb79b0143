// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace loopscope {

/// The factorization L L^T of a symmetric, positive definite matrix of 3 x 3 blocks, few of which
/// are not zero. Which blocks may not be zero, and with it the order of elimination, is chosen
/// once: by approximate minimum degree (Amestoy, Davis, Duff, "An Approximate Minimum Degree
/// Ordering Algorithm", 1996). Columns are factorized one by one, each from those to its left;
/// Davis, "Direct Methods for Sparse Linear Systems", 2006, chapter 4, with blocks in place of
/// numbers.
class BlockCholesky {
 public:
  /// A block below the diagonal: row > column.
  struct Place {
    int row = 0;
    int column = 0;
  };

  /// `places` are all different.
  BlockCholesky(int size, const std::vector<Place>& places);

  /// Factorizes the matrix with these blocks on the diagonal, `damping` added there, and `blocks`
  /// at the places. Whether it is positive definite.
  bool Factorize(const std::vector<Eigen::Matrix3d>& diagonal, const Eigen::VectorXd& damping,
                 const std::vector<Eigen::Matrix3d>& blocks);

  /// The solution for the right-hand side `right`. Factorize must have succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  /// Where a block of the matrix stands in L before it is factorized.
  struct Target {
    int index = 0;
    bool transposed = false;
  };

  void ChooseOrder(int size, const std::vector<Place>& places);
  void LayOutColumns(const std::vector<Place>& places);
  void FindTargets(const std::vector<Place>& places);
  /// Where `row` of `column` stands in blocks_.
  int IndexOf(int row, int column) const;

  // Rows and columns are those of L, in the order of elimination.
  std::vector<int> eliminated_;          ///< the unknown of each column
  std::vector<int> column_of_;           ///< of each unknown
  std::vector<int> begin_;               ///< of a column in rows_ and blocks_; one more at the end
  std::vector<int> rows_;                ///< of the blocks below the diagonal, ascending
  std::vector<Target> targets_;          ///< of each place
  std::vector<Eigen::Matrix3d> blocks_;  ///< of L below the diagonal
  std::vector<Eigen::Matrix3d> inverses_;  ///< of the blocks of L on the diagonal
};

}  // namespace loopscope
