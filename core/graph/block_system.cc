// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/block_system.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <Eigen/LU>

namespace loopscope {
namespace {

/// Numbers blocks of the lower half in the order in which they are asked for.
class BlockNumbers {
 public:
  explicit BlockNumbers(int num_columns) : rows_of_column_(num_columns) {}

  int Of(int row, int column) {
    assert(row >= column);
    auto& rows = rows_of_column_[column];
    const auto found = std::lower_bound(rows.begin(), rows.end(), std::pair(row, 0));
    if (found != rows.end() && found->first == row) return found->second;
    const int number = static_cast<int>(blocks_.size());
    blocks_.push_back({row, column});
    rows.insert(found, {row, number});
    return number;
  }

  const std::vector<BlockSystem::Coupling>& blocks() const { return blocks_; }

 private:
  std::vector<std::vector<std::pair<int, int>>> rows_of_column_;  ///< row and number, by row
  std::vector<BlockSystem::Coupling> blocks_;
};

}  // namespace

BlockSystem::BlockSystem(int num_unknowns, std::vector<Coupling> couplings, int first_leaf)
    : couplings_(std::move(couplings)),
      diagonal_(num_unknowns, Eigen::Matrix3d::Zero()),
      blocks_(couplings_.size(), Eigen::Matrix3d::Zero()),
      reduced_of_(num_unknowns, -1) {
  FindLeaves(first_leaf);
  LayOutReduced();
}

void BlockSystem::FindLeaves(int first_leaf) {
  const int num_unknowns = static_cast<int>(diagonal_.size());
  std::vector<std::vector<int>> neighbors(num_unknowns);
  for (const Coupling& c : couplings_) {
    neighbors[c.row].push_back(c.column);
    neighbors[c.column].push_back(c.row);
  }
  std::vector<bool> is_leaf(num_unknowns, false);
  for (int i = first_leaf; i < num_unknowns; ++i) {
    is_leaf[i] = std::none_of(neighbors[i].begin(), neighbors[i].end(),
                              [&](int neighbor) { return is_leaf[neighbor]; });
  }
  std::vector<int> leaf_of(num_unknowns, -1);
  for (int i = 0; i < num_unknowns; ++i) {
    if (is_leaf[i]) {
      leaf_of[i] = static_cast<int>(leaves_.size());
      leaves_.push_back({i, {}, {}, Eigen::Matrix3d::Zero()});
    } else {
      reduced_of_[i] = static_cast<int>(kept_.size());
      kept_.push_back(i);
    }
  }
  for (int i = 0; i < static_cast<int>(couplings_.size()); ++i) {
    const auto [row, column] = couplings_[i];
    if (is_leaf[row]) {
      leaves_[leaf_of[row]].couplings.push_back({i, column, false});
    } else if (is_leaf[column]) {
      leaves_[leaf_of[column]].couplings.push_back({i, row, true});
    } else {
      kept_couplings_.push_back(i);
    }
  }
  for (Leaf& leaf : leaves_) {
    std::sort(leaf.couplings.begin(), leaf.couplings.end(),
              [](const LeafCoupling& a, const LeafCoupling& b) { return a.to < b.to; });
  }
}

void BlockSystem::LayOutReduced() {
  const int size = static_cast<int>(kept_.size());
  BlockNumbers numbers(size);
  for (int i = 0; i < size; ++i) numbers.Of(i, i);
  for (const int i : kept_couplings_) {
    kept_coupling_block_.push_back(
        numbers.Of(reduced_of_[couplings_[i].row], reduced_of_[couplings_[i].column]));
  }
  for (Leaf& leaf : leaves_) {
    for (std::size_t b = 0; b < leaf.couplings.size(); ++b) {
      for (std::size_t a = 0; a <= b; ++a) {
        leaf.complement.push_back(
            numbers.Of(reduced_of_[leaf.couplings[b].to], reduced_of_[leaf.couplings[a].to]));
      }
    }
  }
  const std::vector<Coupling>& blocks = numbers.blocks();
  reduced_blocks_.resize(blocks.size());
  std::vector<Eigen::Triplet<int>> entries;  // whose value is the place in value_of_, for now
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const auto [row, column] = blocks[block];
    for (int k = 0; k < 9; ++k) {
      const int r = 3 * row + k % 3;
      const int c = 3 * column + k / 3;
      if (r >= c) entries.emplace_back(r, c, static_cast<int>(9 * block) + k);
    }
  }
  Eigen::SparseMatrix<int> places(3 * size, 3 * size);
  places.setFromTriplets(entries.begin(), entries.end());
  value_of_.assign(9 * blocks.size(), -1);
  for (int i = 0; i < places.nonZeros(); ++i) value_of_[places.valuePtr()[i]] = i;
  reduced_ = places.cast<double>();
  cholesky_.analyzePattern(reduced_);
}

void BlockSystem::SetZero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Eigen::Matrix3d::Zero());
  std::fill(blocks_.begin(), blocks_.end(), Eigen::Matrix3d::Zero());
}

bool BlockSystem::Factorize(const Eigen::VectorXd& damping) {
  std::fill(reduced_blocks_.begin(), reduced_blocks_.end(), Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    reduced_blocks_[i] = diagonal_[kept_[i]];
    reduced_blocks_[i].diagonal() += damping.segment<3>(3 * kept_[i]);
  }
  for (std::size_t i = 0; i < kept_couplings_.size(); ++i) {
    reduced_blocks_[kept_coupling_block_[i]] += blocks_[kept_couplings_[i]];
  }
  if (!EliminateLeaves(damping)) return false;
  for (std::size_t i = 0; i < value_of_.size(); ++i) {
    if (value_of_[i] >= 0) reduced_.valuePtr()[value_of_[i]] = reduced_blocks_[i / 9].data()[i % 9];
  }
  cholesky_.factorize(reduced_);
  return cholesky_.info() == Eigen::Success;
}

bool BlockSystem::EliminateLeaves(const Eigen::VectorXd& damping) {
  for (Leaf& leaf : leaves_) {
    Eigen::Matrix3d own = diagonal_[leaf.unknown];
    own.diagonal() += damping.segment<3>(3 * leaf.unknown);
    bool invertible = false;
    own.computeInverseWithCheck(leaf.inverse, invertible, 0.0);
    if (!invertible || !leaf.inverse.allFinite()) return false;
    auto complement = leaf.complement.begin();
    for (std::size_t b = 0; b < leaf.couplings.size(); ++b) {
      const Eigen::Matrix3d left = RowOf(leaf.couplings[b]).transpose() * leaf.inverse;
      for (std::size_t a = 0; a <= b; ++a) {
        reduced_blocks_[*complement++].noalias() -= left * RowOf(leaf.couplings[a]);
      }
    }
  }
  return true;
}

Eigen::Matrix3d BlockSystem::RowOf(const LeafCoupling& coupling) const {
  const Eigen::Matrix3d& block = blocks_[coupling.index];
  return coupling.transposed ? Eigen::Matrix3d(block.transpose()) : block;
}

Eigen::VectorXd BlockSystem::Solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd reduced(3 * kept_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    reduced.segment<3>(3 * i) = right.segment<3>(3 * kept_[i]);
  }
  for (const Leaf& leaf : leaves_) {
    const Eigen::Vector3d own = leaf.inverse * right.segment<3>(3 * leaf.unknown);
    for (const LeafCoupling& c : leaf.couplings) {
      reduced.segment<3>(3 * reduced_of_[c.to]) -= RowOf(c).transpose() * own;
    }
  }
  reduced = cholesky_.solve(reduced).eval();
  Eigen::VectorXd solution(right.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    solution.segment<3>(3 * kept_[i]) = reduced.segment<3>(3 * i);
  }
  for (const Leaf& leaf : leaves_) {
    Eigen::Vector3d own = right.segment<3>(3 * leaf.unknown);
    for (const LeafCoupling& c : leaf.couplings) {
      own -= RowOf(c) * reduced.segment<3>(3 * reduced_of_[c.to]);
    }
    solution.segment<3>(3 * leaf.unknown) = leaf.inverse * own;
  }
  return solution;
}

Eigen::VectorXd BlockSystem::Multiply(const Eigen::VectorXd& vector) const {
  Eigen::VectorXd product(vector.size());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    product.segment<3>(3 * i) = diagonal_[i] * vector.segment<3>(3 * i);
  }
  for (std::size_t i = 0; i < couplings_.size(); ++i) {
    const auto [row, column] = couplings_[i];
    product.segment<3>(3 * row) += blocks_[i] * vector.segment<3>(3 * column);
    product.segment<3>(3 * column) += blocks_[i].transpose() * vector.segment<3>(3 * row);
  }
  return product;
}

}  // namespace loopscope
