// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/sector_queue.h"

#include <algorithm>
#include <utility>

#include "core/matching/block_sums.h"

namespace loopscope {
namespace {

/// Of a square of blocks: half of it, so that the other half may be left out.
constexpr int kRowsPerSector = 4;
static_assert(kBlocksPerSide % kRowsPerSector == 0);

constexpr int kMaxLevel = 1;

}  // namespace

SectorQueue::SectorQueue(const PrecomputedGrids& grids, const SearchWindow& window,
                         const TurnedScan& scan, int start_height, bool with_bounds)
    : grids_(grids),
      window_(window),
      scan_(scan),
      start_height_(start_height),
      with_bounds_(with_bounds) {
  const int w = window.num_linear_steps;
  const auto is_worth_it = [&](int level) {
    return with_bounds && HeightOf(level) <= grids.max_height() &&
           2 * w >= kBlocksPerSide << HeightOf(level) &&
           TurnedScan::HasLowestCells(window, 1 << HeightOf(level));
  };
  int level = 0;
  while (level < kMaxLevel && is_worth_it(level + 1)) ++level;
  AddSectors({{-w, -w}, {w, w}, -window.num_angular_steps, window.num_angular_steps}, level);
}

std::optional<Sector> SectorQueue::Pop(int min_bound) {
  while (!sectors_.empty() && sectors_.top().bound >= min_bound) {
    const Sector sector = sectors_.top();
    sectors_.pop();
    if (sector.level == 0) return sector;
    AddSectors(sector, sector.level - 1);
  }
  return std::nullopt;
}

void SectorQueue::AddSectors(const Sector& area, int level) {
  const int side = kBlocksPerSide << HeightOf(level);  // [cells] of a square
  const int num_angles = 1 << HeightOf(level);
  for (int angle = area.first_angle; angle <= area.last_angle; angle += num_angles) {
    const int end_angle = std::min(angle + num_angles - 1, area.last_angle);
    const std::vector<CellIndex> none;
    const std::vector<CellIndex>& cells = with_bounds_ ? LowestCellsAt(angle, end_angle) : none;
    for (int y = area.first.y; y <= area.last.y; y += side) {
      for (int x = area.first.x; x <= area.last.x; x += side) {
        const CellIndex last{std::min(x + side - 1, area.last.x),
                             std::min(y + side - 1, area.last.y)};
        Sector square{{x, y}, last, angle, end_angle};
        square.level = level;
        if (with_bounds_) {
          AddRowsOfSquare(square, cells);
        } else {
          sectors_.push(square);
        }
      }
    }
  }
}

void SectorQueue::AddRowsOfSquare(const Sector& square, const std::vector<CellIndex>& cells) {
  const int height = HeightOf(square.level);
  const int num_rows = ((square.last.y - square.first.y) >> height) + 1;
  const int num_columns = ((square.last.x - square.first.x) >> height) + 1;
  const BlockSums sums =
      SumBlocks(grids_.swept_at_height(height), cells.data(), cells.size(), square.first, num_rows);
  for (int row = 0; row < num_rows; row += kRowsPerSector) {
    Sector sector = square;
    sector.first.y += row << height;
    sector.last.y = std::min(sector.first.y + (kRowsPerSector << height) - 1, square.last.y);
    sector.bound = MaxOfBlocks(&sums[row * kBlocksPerSide],
                               std::min(kRowsPerSector, num_rows - row), num_columns);
    sectors_.push(sector);
  }
}

const std::vector<CellIndex>& SectorQueue::LowestCellsAt(int first_angle, int last_angle) {
  std::vector<CellIndex>& cells = lowest_cells_[{first_angle, last_angle}];
  if (cells.empty()) cells = scan_.LowestCells(first_angle, last_angle);
  return cells;
}

}  // namespace loopscope
