// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// How GoogleTest shows a cell.
inline void PrintTo(CellIndex cell, std::ostream* out) {
  *out << "(" << cell.x << ", " << cell.y << ")";
}

/// Rows of characters, one a cell, the row of the highest y first as on a map.
using Drawing = std::vector<std::string>;

/// The rows as lines of one text, which GoogleTest compares line by line.
inline std::string ToText(const Drawing& drawing) {
  std::string text;
  for (const std::string& row : drawing) text += row + "\n";
  return text;
}

/// The cells that are drawn as `symbol`, if the lower left character stands at `low`.
inline std::vector<CellIndex> CellsDrawnAs(char symbol, const Drawing& drawing,
                                           CellIndex low = {}) {
  std::vector<CellIndex> cells;
  const int height = static_cast<int>(drawing.size());
  for (int row = 0; row < height; ++row) {
    for (int x = 0; x < static_cast<int>(drawing[row].size()); ++x) {
      if (drawing[row][x] == symbol) cells.push_back({low.x + x, low.y + height - 1 - row});
    }
  }
  return cells;
}

/// A grid of the digits of `drawing`, which are tenths of a probability; all else is unknown.
inline ProbabilityGrid GridDrawn(const Drawing& drawing, double resolution, CellIndex low = {}) {
  ProbabilityGrid grid(resolution);
  for (int tenths = 1; tenths <= 9; ++tenths) {
    const auto cells = CellsDrawnAs(static_cast<char>('0' + tenths), drawing, low);
    grid.GrowToInclude(BoxOf(cells));
    grid.Update(cells, OddsUpdate(0.1 * tenths));
  }
  return grid;
}

/// The cells of `box` with their probabilities in tenths, and blanks where unknown.
inline std::string Draw(const ProbabilityGrid& grid, const CellBox& box) {
  Drawing drawing(box.height, std::string(box.width, ' '));
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      const CellIndex cell{box.min.x + x, box.min.y + y};
      if (!grid.known(cell)) continue;
      const auto tenths = static_cast<char>(10.0 * grid.probability(cell) + 0.5);
      drawing[box.height - 1 - y][x] = static_cast<char>('0' + tenths);
    }
  }
  return ToText(drawing);
}

/// The cells of `box`: '#' for a hit, '.' for a miss, '!' for one that is listed twice. Cells
/// outside of the box are told in lines below.
inline std::string Draw(const ScanCells& cells, const CellBox& box) {
  Drawing drawing(box.height, std::string(box.width, ' '));
  std::string outside;
  const auto draw = [&](CellIndex cell, char symbol) {
    if (!box.Contains(cell)) {
      outside += "outside: " + std::to_string(cell.x) + ", " + std::to_string(cell.y) + "\n";
      return;
    }
    char& drawn = drawing[box.height - 1 - (cell.y - box.min.y)][cell.x - box.min.x];
    drawn = drawn == ' ' ? symbol : '!';
  };
  for (const CellIndex cell : cells.hits) draw(cell, '#');
  for (const CellIndex cell : cells.misses) draw(cell, '.');
  return ToText(drawing) + outside;
}

}  // namespace loopscope
