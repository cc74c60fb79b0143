// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/prior_search.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <functional>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>

#include "core/matching/block_sums.h"
#include "core/matching/precomputed_grids.h"
#include "core/matching/search_lattice.h"
#include "core/matching/turned_scan.h"

namespace loopscope {
namespace {

/// Blocks of 8 x 8 poses are bounded before their poses are scored.
constexpr int kBlockHeight = 3;
constexpr int kBlockSide = 1 << kBlockHeight;
static_assert(kBlockSide == kBlocksPerSide, "the poses of a block are summed at once");

constexpr int kOutOfReach = -1;

class PriorSearch {
 public:
  PriorSearch(const PointCloud& points, const ProbabilityGrid& grid,
              const Pose2& submap_from_before, const MotionPrior& prior)
      : points_(points),
        prior_(prior),
        grids_(grid, kBlockHeight + 1),
        window_(MakeSearchWindow(points, submap_from_before, prior.reach(),
                                 MotionPrior::kAngularReach, grid.resolution())),
        scan_(window_, points),
        blocks_per_side_(2 * window_.num_linear_steps / kBlockSide + 1),
        highest_weights_(MotionPrior::kNumTurns),
        best_{submap_from_before, 0.0} {
    FindPlaceBins();
  }

  CorrelativeMatch Run() {
    for (int angle = -window_.num_angular_steps; angle <= window_.num_angular_steps; ++angle) {
      BoundBlocksAt(angle);
    }
    // Best first; most are never asked for.
    std::make_heap(blocks_.begin(), blocks_.end(), std::greater<>());
    while (!blocks_.empty() && blocks_.front().bound > best_.score) {
      std::pop_heap(blocks_.begin(), blocks_.end(), std::greater<>());
      ScorePosesOf(blocks_.back(), scan_.CellsAt(blocks_.back().angle));
      blocks_.pop_back();
    }
    return best_;
  }

 private:
  struct Block {
    double bound = 0.0;
    int angle = 0;
    CellIndex offset;  ///< of its first pose

    /// The first to be scored has the highest bound.
    friend bool operator<(const Block& a, const Block& b) {
      return std::tuple(-a.bound, a.angle, a.offset.y, a.offset.x) <
             std::tuple(-b.bound, b.angle, b.offset.y, b.offset.x);
    }
    friend bool operator>(const Block& a, const Block& b) { return b < a; }
  };

  /// Bounds the blocks at an angle, scores the poses of the best, and keeps those that may beat it.
  void BoundBlocksAt(int angle) {
    const auto turn_bin = prior_.TurnBin(angle * window_.angular_step);
    if (!turn_bin) return;
    const std::vector<CellIndex> cells = scan_.CellsAt(angle);
    const std::vector<float>& highest_weights = HighestWeights(*turn_bin);
    const std::size_t first_block = blocks_.size();
    for (int row = 0; row < blocks_per_side_; row += kBlocksPerSide) {
      for (int column = 0; column < blocks_per_side_; column += kBlocksPerSide) {
        const BlockSums sums = SumBlocks(grids_.at_height(kBlockHeight), cells.data(), cells.size(),
                                         OffsetOf(row, column));
        AddBlocks(sums, row, column, angle, highest_weights);
      }
    }
    const auto best = std::min_element(blocks_.begin() + first_block, blocks_.end());
    if (best != blocks_.end()) ScorePosesOf(*best, cells);
  }

  void AddBlocks(const BlockSums& sums, int first_row, int first_column, int angle,
                 const std::vector<float>& highest_weights) {
    const int last_row = std::min(first_row + kBlocksPerSide, blocks_per_side_);
    const int last_column = std::min(first_column + kBlocksPerSide, blocks_per_side_);
    for (int row = first_row; row < last_row; ++row) {
      for (int column = first_column; column < last_column; ++column) {
        const int sum = sums[(row - first_row) * kBlocksPerSide + column - first_column];
        const double bound = MeanOf(sum) * highest_weights[row * blocks_per_side_ + column];
        if (bound > best_.score) blocks_.push_back({bound, angle, OffsetOf(row, column)});
      }
    }
  }

  void ScorePosesOf(const Block& block, const std::vector<CellIndex>& cells) {
    const int turn_bin = *prior_.TurnBin(block.angle * window_.angular_step);
    const BlockSums sums = SumBlocks(grids_.at_height(0), cells.data(), cells.size(), block.offset);
    for (int k = 0; k < kBlockSide * kBlockSide; ++k) {
      const CellIndex offset{block.offset.x + k % kBlockSide, block.offset.y + k / kBlockSide};
      const int place_bin = PlaceBinAt(offset);
      if (place_bin == kOutOfReach) continue;
      const double score = MeanOf(sums[k]) * prior_.Weight(place_bin, turn_bin);
      if (score > best_.score) best_ = {PoseInWindow(window_, offset, block.angle), score};
    }
  }

  /// Of the blocks of the window, row by row.
  const std::vector<float>& HighestWeights(int turn_bin) {
    std::vector<float>& highest = highest_weights_[turn_bin];
    if (!highest.empty()) return highest;
    highest.assign(blocks_per_side_ * blocks_per_side_, 0.0F);
    const int radius = window_.num_linear_steps;
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const int place_bin = PlaceBinAt({x, y});
        if (place_bin == kOutOfReach) continue;
        float& of_block =
            highest[(y + radius) / kBlockSide * blocks_per_side_ + (x + radius) / kBlockSide];
        of_block = std::max(of_block, prior_.Weight(place_bin, turn_bin));
      }
    }
    return highest;
  }

  void FindPlaceBins() {
    const int radius = window_.num_linear_steps;
    const Eigen::Rotation2Dd base_from_submap(-window_.submap_from_scan_guess.rotation);
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const Eigen::Vector2d offset = Eigen::Vector2d(x, y) * window_.resolution;
        place_bins_.push_back(prior_.PlaceBin(base_from_submap * offset).value_or(kOutOfReach));
      }
    }
  }

  int PlaceBinAt(CellIndex offset) const {
    const int radius = window_.num_linear_steps;
    if (std::max(std::abs(offset.x), std::abs(offset.y)) > radius) return kOutOfReach;
    return place_bins_[(offset.y + radius) * (2 * radius + 1) + offset.x + radius];
  }

  CellIndex OffsetOf(int row, int column) const {
    return {column * kBlockSide - window_.num_linear_steps,
            row * kBlockSide - window_.num_linear_steps};
  }

  double MeanOf(int sum) const {
    return PrecomputedGrids::MeanProbability(sum, static_cast<int>(points_.size()));
  }

  const PointCloud& points_;
  const MotionPrior& prior_;
  PrecomputedGrids grids_;
  SearchWindow window_;
  TurnedScan scan_;
  int blocks_per_side_;
  std::vector<int> place_bins_;                      // of all offsets, row by row
  std::vector<std::vector<float>> highest_weights_;  // of turns that were asked for
  std::vector<Block> blocks_;
  CorrelativeMatch best_;
};

}  // namespace

CorrelativeMatch MatchWithPrior(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                const Pose2& submap_from_before, const MotionPrior& prior) {
  assert(!points_in_scan.empty());
  return PriorSearch(points_in_scan, grid, submap_from_before, prior).Run();
}

}  // namespace loopscope
