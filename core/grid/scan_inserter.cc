// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/scan_inserter.h"

namespace loopscope {

ScanInserter::ScanInserter(const ScanInserterOptions& options)
    : options_(options), hit_(options.hit_probability), miss_(options.miss_probability) {}

void ScanInserter::Insert(const ScanCells& cells, ProbabilityGrid* grid) const {
  grid->GrowToInclude(options_.insert_free_space ? cells.box : BoxOf(cells.hits));
  grid->Update(cells.hits, hit_);
  if (options_.insert_free_space) grid->Update(cells.misses, miss_);
}

}  // namespace loopscope
