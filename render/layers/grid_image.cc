// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/grid_image.h"

#include <cmath>

namespace loopscope {

Color MapColors::At(double probability) const {
  const double occupancy = (probability - kMinProbability) / (kMaxProbability - kMinProbability);
  return Blend(free, occupied, occupancy);
}

MapColors PlainMapColors(const Palette& palette) {
  return {palette.map_free, palette.map_occupied, palette.map_unknown};
}

MapColors DarkMapColors(const Palette& palette) {
  return {palette.dark_free, palette.dark_occupied, palette.dark_unknown};
}

CellImage GridImage(const ProbabilityGrid& grid, const MapColors& colors) {
  const CellBox& box = grid.box();
  CellImage image(box);
  for (int y = box.min.y; y < box.min.y + box.height; ++y) {
    for (int x = box.min.x; x < box.min.x + box.width; ++x) {
      const CellValue value = grid.value({x, y});
      if (value != kUnknown) image.Set({x, y}, colors.At(ProbabilityOf(value)));
    }
  }
  return image;
}

CellImage OddsImage(const ProbabilityGrid& grid, const std::vector<CellIndex>& cells,
                    const Palette& palette) {
  CellImage image(BoxOf(cells));
  for (const CellIndex cell : cells) {
    image.Set(cell, grid.known(cell) ? palette.odds.At(PlaceOnOddsScale(grid.probability(cell)))
                                     : palette.never_seen);
  }
  return image;
}

double PlaceOnOddsScale(double probability) {
  return 0.5 + 0.5 * std::log(Odds(probability)) / std::log(Odds(kMaxProbability));
}

CellImage CellsImage(const std::vector<CellIndex>& cells, const Color& color) {
  CellImage image(BoxOf(cells));
  for (const CellIndex cell : cells) image.Set(cell, color);
  return image;
}

}  // namespace loopscope
