// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>

namespace loopscope {

/// A symmetric, positive definite system of linear equations, of 3 x 3 blocks, few of which are not
/// zero. Unknowns of which no two are coupled ("leaves") are eliminated one by one (Schur
/// complement); what remains is factorized by a sparse Cholesky whose order is chosen once.
class BlockSystem {
 public:
  /// Two unknowns with a block of their own off the diagonal: row > column.
  struct Coupling {
    int row = 0;
    int column = 0;
  };

  /// `couplings` are all different. Of the unknowns from `first_leaf` on, those become leaves that
  /// are coupled with no leaf before them.
  BlockSystem(int num_unknowns, std::vector<Coupling> couplings, int first_leaf);

  void SetZero();
  Eigen::Matrix3d& diagonal(int unknown) { return diagonal_[unknown]; }
  /// The block of a coupling, by its index.
  Eigen::Matrix3d& coupling(int index) { return blocks_[index]; }

  /// Factorizes the matrix with `damping` added to its diagonal, three numbers for each unknown.
  /// Whether it is positive definite.
  bool Factorize(const Eigen::VectorXd& damping);

  /// The solution for the right-hand side `right`, three numbers for each unknown. Factorize must
  /// have succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

  /// The matrix, without damping, times `vector`.
  Eigen::VectorXd Multiply(const Eigen::VectorXd& vector) const;

 private:
  struct LeafCoupling {
    int index = 0;            ///< into couplings_
    int to = 0;               ///< the unknown at its other end
    bool transposed = false;  ///< the leaf is its column
  };
  struct Leaf {
    int unknown = 0;
    std::vector<LeafCoupling> couplings;  ///< by the unknown at the other end
    std::vector<int> complement;  ///< its blocks in the reduced matrix, for each pair of couplings
    Eigen::Matrix3d inverse;      ///< of its damped diagonal block
  };

  void FindLeaves(int first_leaf);
  void LayOutReduced();
  /// The block in the row of the leaf.
  Eigen::Matrix3d RowOf(const LeafCoupling& coupling) const;
  bool EliminateLeaves(const Eigen::VectorXd& damping);

  std::vector<Coupling> couplings_;
  std::vector<Eigen::Matrix3d> diagonal_;
  std::vector<Eigen::Matrix3d> blocks_;
  std::vector<Leaf> leaves_;
  std::vector<int> kept_;        ///< unknowns that are no leaves
  std::vector<int> reduced_of_;  ///< place of an unknown in kept_, -1 for leaves

  // The reduced matrix, lower half: blocks on the diagonal, those of couplings between kept
  // unknowns, and those that leaves leave behind.
  std::vector<int> kept_couplings_;       ///< couplings between kept unknowns
  std::vector<int> kept_coupling_block_;  ///< and their blocks
  std::vector<Eigen::Matrix3d> reduced_blocks_;
  std::vector<int> value_of_;  ///< 9 for each block: where its entries stand in reduced_; -1: upper
  Eigen::SparseMatrix<double> reduced_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky_;
};

}  // namespace loopscope
