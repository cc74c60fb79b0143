// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/id.h"

namespace loopscope {

/// How far the robot went from submap to submap, which is what drift grows with. A loop that was
/// closed is a short cut.
class TravelGraph {
 public:
  /// Adds the next submap, `way` [m] after the one before it.
  void AddSubmap(double way);

  /// `a` and `b` were found to be next to each other.
  void AddLoop(SubmapId a, SubmapId b);

  /// The shortest way [m] from `from` to every submap. The last answer is kept, for nodes of one
  /// submap ask for the same: the reference holds until the next call, AddSubmap or AddLoop.
  const std::vector<double>& WaysFrom(SubmapId from) const;

 private:
  struct Edge {
    int to = 0;
    double way = 0.0;
  };
  void AddEdge(int a, int b, double way);
  std::vector<double> ShortestWays(SubmapId from) const;

  std::vector<std::vector<Edge>> edges_;
  mutable std::optional<std::pair<SubmapId, std::vector<double>>> last_answer_;
};

}  // namespace loopscope
