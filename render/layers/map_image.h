// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "render/layers/cell_image.h"
#include "render/layers/grid_image.h"
#include "render/layers/log_odds_sum.h"
#include "render/scene.h"

namespace loopscope {

class MapMemory;

/// The raster for a panel: its own pixels, or half cells of `resolution` where those are larger.
Raster RasterFor(const FlatCamera& camera, const Box& frame, double resolution);

/// Puts all grids into one image. Their odds for a pixel are multiplied, as if they were
/// independent observations (eq. 3); a grid has the highest odds of its known cells there, so that
/// no wall is lost in a small picture. Pixels that no grid knows are clear, and far from all grids
/// left out. From the second image on, which tells that there will be more, most of the last one is
/// remembered, which changes none: as a recording is stepped through, the grids of all submaps but
/// the last two stay as they are until poses are optimized.
class MapComposer {
 public:
  MapComposer();
  ~MapComposer();

  std::shared_ptr<const CellImage> Compose(const std::vector<PlacedGrid>& grids,
                                           const Raster& raster, const MapColors& colors);

 private:
  bool composed_ = false;              ///< any image
  std::unique_ptr<MapMemory> memory_;  ///< null until the second image
};

vtkSmartPointer<vtkActor> MapLayer(const std::vector<PlacedGrid>& grids, const Raster& raster,
                                   const MapColors& colors, MapComposer* composer);

}  // namespace loopscope
