// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/scan_inserter.h"

namespace loopscope {

ScanInserter::ScanInserter(const ScanInserterOptions& options)
    : options_(options), hit_(options.hit_probability), miss_(options.miss_probability) {}

void ScanInserter::Insert(const ScanCells& cells, ProbabilityGrid* grid, CellIndex origin) const {
  CellBox box = options_.insert_free_space ? cells.box : BoxOf(cells.hits);
  box.min = {box.min.x - origin.x, box.min.y - origin.y};
  grid->GrowToInclude(box);
  grid->Update(cells.hits, hit_, origin);
  if (options_.insert_free_space) grid->Update(cells.misses, miss_, origin);
}

}  // namespace loopscope
