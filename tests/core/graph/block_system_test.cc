// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/block_system.h"

#include <memory>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

Eigen::Matrix3d RandomMatrix(Random* random) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix.data()[i] = random->Uniform(-1.0, 1.0);
  return matrix;
}

/// A system and the same as a dense matrix.
struct Systems {
  std::unique_ptr<BlockSystem> blocks;
  Eigen::MatrixXd dense;
};

/// Four submaps, all coupled, and nodes with one to three couplings to them; the last two nodes are
/// coupled with each other too.
Systems MakeSystems(int seed) {
  constexpr int kFirstNode = 4;
  constexpr int kNumUnknowns = 12;
  Random random(seed);
  std::vector<BlockSystem::Coupling> couplings{{1, 0}, {2, 1}, {3, 2}};
  for (int node = kFirstNode; node < kNumUnknowns; ++node) {
    for (int i = 0; i <= random.Below(3); ++i) couplings.push_back({node, (node + i) % kFirstNode});
  }
  couplings.push_back({kNumUnknowns - 1, kNumUnknowns - 2});
  Systems systems{std::make_unique<BlockSystem>(kNumUnknowns, couplings),
                  Eigen::MatrixXd::Zero(3 * kNumUnknowns, 3 * kNumUnknowns)};
  for (std::size_t i = 0; i < couplings.size(); ++i) {
    const Eigen::Matrix3d block = RandomMatrix(&random);
    systems.blocks->coupling(static_cast<int>(i)) = block;
    systems.dense.block<3, 3>(3 * couplings[i].row, 3 * couplings[i].column) = block;
    systems.dense.block<3, 3>(3 * couplings[i].column, 3 * couplings[i].row) = block.transpose();
  }
  for (int i = 0; i < kNumUnknowns; ++i) {
    const Eigen::Matrix3d half = RandomMatrix(&random);
    systems.blocks->diagonal(i) = half * half.transpose() + 20.0 * Eigen::Matrix3d::Identity();
    systems.dense.block<3, 3>(3 * i, 3 * i) = systems.blocks->diagonal(i);
  }
  return systems;
}

TEST(BlockSystem, HasTheSolutionOfTheDenseSystem) {
  for (int seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Systems systems = MakeSystems(seed);
    const Eigen::Index size = systems.dense.rows();
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
    const Eigen::VectorXd damping = Eigen::VectorXd::LinSpaced(size, 0.0, 3.0);
    ASSERT_TRUE(systems.blocks->Factorize(damping));
    const Eigen::MatrixXd damped = systems.dense + Eigen::MatrixXd(damping.asDiagonal());
    EXPECT_LT((systems.blocks->Solve(right) - damped.ldlt().solve(right)).norm(), 1e-10);
  }
}

TEST(BlockSystem, MultipliesAsTheDenseSystem) {
  const Systems systems = MakeSystems(3);
  const Eigen::VectorXd vector = Eigen::VectorXd::LinSpaced(systems.dense.rows(), -1.0, 2.0);
  EXPECT_LT((systems.blocks->Multiply(vector) - systems.dense * vector).norm(), 1e-10);
}

TEST(BlockSystem, TellsWhenItIsNotPositiveDefinite) {
  Systems systems = MakeSystems(1);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(systems.dense.rows());
  EXPECT_TRUE(systems.blocks->Factorize(none));
  systems.blocks->diagonal(2) -= 40.0 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(systems.blocks->Factorize(none));
}

TEST(BlockSystem, TellsWhenAnUnknownIsNotDetermined) {
  Systems systems = MakeSystems(1);
  systems.blocks->diagonal(6).setZero();
  EXPECT_FALSE(systems.blocks->Factorize(Eigen::VectorXd::Zero(systems.dense.rows())));
}

TEST(BlockSystem, IsEmptiedBySetZero) {
  Systems systems = MakeSystems(2);
  const Eigen::Index size = systems.dense.rows();
  systems.blocks->SetZero();
  ASSERT_TRUE(systems.blocks->Factorize(Eigen::VectorXd::Constant(size, 4.0)));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(size, 1.0, 2.0);
  EXPECT_LT((systems.blocks->Solve(right) - 0.25 * right).norm(), 1e-12);
}

}  // namespace
}  // namespace loopscope
