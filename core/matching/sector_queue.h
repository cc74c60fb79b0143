// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "core/matching/precomputed_grids.h"
#include "core/matching/search_trace.h"
#include "core/matching/turned_scan.h"

namespace loopscope {

/// Start nodes (eq. 13) that lie side by side, at neighbouring angles, with a bound for all of
/// them.
struct Sector {
  CellIndex first;  ///< [cells] offsets of the window, both ends included
  CellIndex last;
  int first_angle = 0;
  int last_angle = 0;
  int bound = std::numeric_limits<int>::max();  ///< on the sums of eq. 16
  int level = 0;

  friend bool operator<(const Sector& a, const Sector& b) { return a.bound < b.bound; }
};

/// The start nodes of a window in sectors, the one with the highest bound first. They are bounded
/// like nodes of the tree, by maxima over boxes, but at many angles at once: over the cells that
/// the points sweep. A wide window begins with sectors of twice the size in x, in y and in angle,
/// which are split where they may hold a winner.
class SectorQueue {
 public:
  /// Start nodes are at `start_height`. Without bounds each sector comes before all that have one.
  SectorQueue(const PrecomputedGrids& grids, const SearchWindow& window, const TurnedScan& scan,
              int start_height, bool with_bounds);

  /// Takes the sector with the highest bound, if that is `min_bound` or more.
  std::optional<Sector> Pop(int min_bound);

 private:
  int HeightOf(int level) const { return start_height_ + level; }
  /// Splits `area` into sectors of `level`.
  void AddSectors(const Sector& area, int level);
  void AddRowsOfSquare(const Sector& square, const std::vector<CellIndex>& cells);
  /// Kept, for sectors of the same angles are split one after the other.
  const std::vector<CellIndex>& LowestCellsAt(int first_angle, int last_angle);

  const PrecomputedGrids& grids_;
  const SearchWindow& window_;
  const TurnedScan& scan_;
  int start_height_;
  bool with_bounds_;
  std::priority_queue<Sector> sectors_;
  std::map<std::pair<int, int>, std::vector<CellIndex>> lowest_cells_;  ///< by angles
};

}  // namespace loopscope
