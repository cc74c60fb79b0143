// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/active_submaps.h"

#include "core/grid/ray_cast.h"

namespace loopscope {

CellIndex OriginOfLattice(const Pose2& local_from_submap, double resolution) {
  return CellOf(local_from_submap.translation, resolution);
}

ScanCells ToSubmapLattice(ScanCells cells, const Pose2& local_from_submap, double resolution) {
  const CellIndex origin = OriginOfLattice(local_from_submap, resolution);
  for (std::vector<CellIndex>* list : {&cells.hits, &cells.misses}) {
    for (CellIndex& cell : *list) cell = {cell.x - origin.x, cell.y - origin.y};
  }
  cells.box.min = {cells.box.min.x - origin.x, cells.box.min.y - origin.y};
  return cells;
}

ActiveSubmaps::ActiveSubmaps(const SubmapsOptions& options)
    : options_(options), inserter_(options.range_data_inserter) {}

const ActiveSubmap* ActiveSubmaps::MatchingSubmap() const {
  return submaps_.empty() ? nullptr : &submaps_.front();
}

ActiveSubmaps::Insertion ActiveSubmaps::Insert(const Pose2& local_from_base,
                                               const RangeData& range_data_in_base) {
  Insertion insertion;
  if (NeedsNewSubmap()) insertion.started_local_from_submap = StartSubmap(local_from_base);
  insertion.first_submap = submaps_.front().id;
  insertion.num_submaps = static_cast<int>(submaps_.size());
  const ScanCells cells_in_local =
      CastRays(Transform(local_from_base, range_data_in_base), options_.grid_resolution,
               options_.range_data_inserter.max_wall_gap);
  for (ActiveSubmap& submap : submaps_) {
    inserter_.Insert(cells_in_local, &submap.grid,
                     OriginOfLattice(submap.local_from_submap, options_.grid_resolution));
    ++submap.num_nodes;
  }
  if (submaps_.front().num_nodes == 2 * options_.num_range_data) {
    insertion.finished = std::move(submaps_.front());
    submaps_.erase(submaps_.begin());
  }
  return insertion;
}

bool ActiveSubmaps::NeedsNewSubmap() const {
  return submaps_.empty() || submaps_.back().num_nodes == options_.num_range_data;
}

Pose2 ActiveSubmaps::StartSubmap(const Pose2& local_from_base) {
  const double r = options_.grid_resolution;
  const Pose2 local_from_submap(CenterOf(CellOf(local_from_base.translation, r), r), 0.0);
  submaps_.push_back({SubmapId{num_started_++}, local_from_submap, ProbabilityGrid(r), 0});
  return local_from_submap;
}

}  // namespace loopscope
