// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/grid/scan_inserter.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.submaps.
struct SubmapsOptions {
  int num_range_data = 90;        ///< a submap is finished after twice as many nodes
  double grid_resolution = 0.05;  ///< grid_options_2d.resolution, r [m]
  ScanInserterOptions range_data_inserter;
};

/// A submap that still grows. Its frame is parallel to the local frame, with its origin on a point
/// of the lattice r Z x r Z of the local frame near where it was begun: so the lattices of all
/// submaps coincide in the local frame, and the cells of a scan are found once for all.
struct ActiveSubmap {
  SubmapId id;
  Pose2 local_from_submap;
  ProbabilityGrid grid;
  int num_nodes = 0;
};

/// The cell of the lattice of the local frame that is (0, 0) on that of a submap.
CellIndex OriginOfLattice(const Pose2& local_from_submap, double resolution);

/// `cells` of the lattice of the local frame on that of a submap.
ScanCells ToSubmapLattice(ScanCells cells, const Pose2& local_from_submap, double resolution);

/// The two submaps into which scans are inserted: one that is half full and serves for matching,
/// and the next one.
class ActiveSubmaps {
 public:
  explicit ActiveSubmaps(const SubmapsOptions& options);

  /// The submap to match against, nothing before the first insertion.
  const ActiveSubmap* MatchingSubmap() const;

  struct Insertion {
    SubmapId first_submap;  ///< the scan went into num_submaps submaps, from this one on
    int num_submaps = 0;
    std::optional<Pose2> started_local_from_submap;  ///< of the last of them, if it was begun now
    std::optional<ActiveSubmap> finished;            ///< the first of them, if it is full now
  };
  /// Inserts what the robot saw at `local_from_base` into the active submaps.
  Insertion Insert(const Pose2& local_from_base, const RangeData& range_data_in_base);

 private:
  bool NeedsNewSubmap() const;
  Pose2 StartSubmap(const Pose2& local_from_base);

  SubmapsOptions options_;
  ScanInserter inserter_;
  std::vector<ActiveSubmap> submaps_;  ///< at most two, the older first
  int num_started_ = 0;
};

}  // namespace loopscope
