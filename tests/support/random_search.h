// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/matching/branch_and_bound.h"
#include "tests/support/random_world.h"

namespace loopscope {

/// A search of a few thousand poses in a random world, all of it chosen by `seed`: windows that are
/// not multiples of the blocks, and one to six heights.
class RandomSearch {
 public:
  explicit RandomSearch(int seed) : RandomSearch(Random(seed)) {}

  const RandomWorld& world() const { return world_; }

  SearchOutcome Run(double min_score, SearchTrace* trace) const {
    return RunWithDepth(depth_, min_score, trace);
  }

  SearchOutcome RunWithDepth(int depth, double min_score, SearchTrace* trace) const {
    return BranchAndBoundMatcher(world_.grid, depth)
        .Search(world_.points_in_scan, submap_from_scan_guess_, linear_window_, angular_window_,
                min_score, trace);
  }

  SearchOutcome RunWithRival(double min_score, const RivalCriterion& rival) const {
    return BranchAndBoundMatcher(world_.grid, depth_)
        .SearchWithRival(world_.points_in_scan, submap_from_scan_guess_, linear_window_,
                         angular_window_, min_score, rival);
  }

 private:
  explicit RandomSearch(Random random)
      : world_(MakeRandomWorld(&random)),
        submap_from_scan_guess_(world_.submap_from_scan * Pose2{random.Uniform(-0.3, 0.3),
                                                                random.Uniform(-0.3, 0.3),
                                                                random.Uniform(-0.2, 0.2)}),
        linear_window_(random.Uniform(0.0, 0.5)),
        angular_window_(random.Uniform(0.0, 0.25)),
        depth_(1 + random.Below(6)) {}

  RandomWorld world_;
  Pose2 submap_from_scan_guess_;
  double linear_window_;   // [m]
  double angular_window_;  // [rad]
  int depth_;
};

}  // namespace loopscope
