// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/seen_area.h"

#include <algorithm>
#include <limits>

namespace loopscope {
namespace {

constexpr int kCellsPerBlock = 4;
constexpr std::uint8_t kFarthest = std::numeric_limits<std::uint8_t>::max();

/// Borgefors, "Distance Transformations in Digital Images", 1986: steps to a neighbour along a row
/// or column, and to one along a diagonal.
constexpr int kStep = 5;
constexpr int kDiagonalStep = 7;

/// A cell that was observed and is rather free than occupied.
bool IsSeen(CellValue value) { return value != kUnknown && ProbabilityOf(value) < 0.5; }

}  // namespace

SeenArea::SeenArea(const ProbabilityGrid& grid)
    : block_size_(kCellsPerBlock * grid.resolution()),
      known_(grid.box()),
      width_((known_.width + kCellsPerBlock - 1) / kCellsPerBlock),
      height_((known_.height + kCellsPerBlock - 1) / kCellsPerBlock),
      distances_(static_cast<std::size_t>(width_) * height_, kFarthest) {
  MarkSeenBlocks(grid);
  SpreadDistances();
}

void SeenArea::MarkSeenBlocks(const ProbabilityGrid& grid) {
  for (int y = 0; y < known_.height; ++y) {
    const CellValue* const row =
        grid.cells().data() + static_cast<std::ptrdiff_t>(y) * known_.width;
    for (int x = 0; x < known_.width; ++x) {
      if (IsSeen(row[x])) at(x / kCellsPerBlock, y / kCellsPerBlock) = 0;
    }
  }
}

void SeenArea::SpreadDistances() {
  const auto spread = [this](int x, int y, int to_x, int to_y, int step) {
    if (to_x < 0 || to_x >= width_ || to_y < 0 || to_y >= height_) return;
    at(to_x, to_y) = static_cast<std::uint8_t>(std::min(int{at(to_x, to_y)}, at(x, y) + step));
  };
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      spread(x, y, x + 1, y, kStep);
      spread(x, y, x - 1, y + 1, kDiagonalStep);
      spread(x, y, x, y + 1, kStep);
      spread(x, y, x + 1, y + 1, kDiagonalStep);
    }
  }
  for (int y = height_ - 1; y >= 0; --y) {
    for (int x = width_ - 1; x >= 0; --x) {
      spread(x, y, x - 1, y, kStep);
      spread(x, y, x + 1, y - 1, kDiagonalStep);
      spread(x, y, x, y - 1, kStep);
      spread(x, y, x - 1, y - 1, kDiagonalStep);
    }
  }
}

double SeenArea::DistanceTo(const Eigen::Vector2d& place) const {
  if (distances_.empty()) return std::numeric_limits<double>::infinity();
  const double resolution = block_size_ / kCellsPerBlock;
  const Eigen::Vector2d corner = CenterOf(known_.min, resolution).array() - 0.5 * resolution;
  const Eigen::Vector2d block = (place - corner) / block_size_;
  const Eigen::Vector2d last(width_ - 1, height_ - 1);
  const Eigen::Vector2d nearest = block.cwiseMax(0.0).cwiseMin(last + Eigen::Vector2d::Ones());
  const Eigen::Vector2i index = nearest.cwiseMin(last).cast<int>();
  const double outside = (block - nearest).norm();
  const double inside = distances_[static_cast<std::size_t>(index.y()) * width_ + index.x()];
  return block_size_ * (outside + inside / kStep);
}

}  // namespace loopscope
