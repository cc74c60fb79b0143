// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/cell.h"
#include "core/grid/probability.h"
#include "core/slam/recording.h"

namespace loopscope {

/// A scan that wrote a cell.
struct CellWrite {
  NodeId node;
  bool is_hit = false;
  double odds = 0.0;  ///< of an obstacle, after it
};

/// Which scans wrote the cells of a submap. It is derived once and may then be asked often, also
/// while the recording grows.
class CellHistory {
 public:
  /// Of the first `num_nodes` nodes of `submap`; all by default.
  CellHistory(const Recording& recording, SubmapId submap, int num_nodes = -1);

  /// In the order of insertion; empty if no scan wrote `cell`, which may lie anywhere.
  std::vector<CellWrite> WritesOf(CellIndex cell) const;

 private:
  template <typename Visit>
  void VisitWrites(const std::vector<ScanCells>& cells_of_nodes, const Visit& visit) const;

  NodeId first_node_;
  bool writes_misses_ = true;
  OddsUpdate hit_;
  OddsUpdate miss_;
  CellBox box_;
  std::vector<std::uint32_t> begins_;  // of the writes of each cell of the box, and the end
  std::vector<std::uint32_t> writes_;  // 2 * (node - first node) + is_hit
};

}  // namespace loopscope
