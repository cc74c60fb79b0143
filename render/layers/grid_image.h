// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/probability_grid.h"
#include "render/layers/cell_image.h"
#include "render/palette.h"

namespace loopscope {

/// The three colours of a map.
struct MapColors {
  Color free;      ///< at kMinProbability
  Color occupied;  ///< at kMaxProbability
  Color unknown;

  /// `probability` is that of a known cell.
  Color At(double probability) const;
};

/// White, black and grey.
MapColors PlainMapColors(const Palette& palette);
/// For a map that only stands behind what is drawn on it.
MapColors DarkMapColors(const Palette& palette);

/// The known cells of `grid`; those that are unknown are clear.
CellImage GridImage(const ProbabilityGrid& grid, const MapColors& colors);

/// The odds of `cells` in `grid` on the scale of the palette.
CellImage OddsImage(const ProbabilityGrid& grid, const std::vector<CellIndex>& cells,
                    const Palette& palette);

/// Place of a probability on the scale of odds, which is even in their logarithm: 0 at
/// kMinProbability, 0.5 at even odds, 1 at kMaxProbability.
double PlaceOnOddsScale(double probability);

/// `cells` in one colour.
CellImage CellsImage(const std::vector<CellIndex>& cells, const Color& color);

}  // namespace loopscope
