// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/block_system.h"

#include <algorithm>
#include <utility>

namespace loopscope {

BlockSystem::BlockSystem(int num_unknowns, std::vector<Coupling> couplings)
    : couplings_(std::move(couplings)),
      diagonal_(num_unknowns, Eigen::Matrix3d::Zero()),
      blocks_(couplings_.size(), Eigen::Matrix3d::Zero()),
      cholesky_(num_unknowns, couplings_) {}

void BlockSystem::SetZero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Eigen::Matrix3d::Zero());
  std::fill(blocks_.begin(), blocks_.end(), Eigen::Matrix3d::Zero());
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
