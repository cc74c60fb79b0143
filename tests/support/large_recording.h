// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/slam/recording.h"

namespace loopscope {

/// A run of the size of a long one that no mapper made: the robot goes round and round in a hall,
/// and `num_loops` of its nodes are found again in submaps that lie near. Each scan has eight
/// beams.
class LargeRun {
 public:
  static Recording Make(int num_nodes, int num_loops) {
    return LargeRun(num_nodes, num_loops).Build();
  }

 private:
  static constexpr int kNodesOfHalfSubmap = 40;
  static constexpr int kNodesOfRound = 1000;

  LargeRun(int num_nodes, int num_loops) : num_nodes_(num_nodes), num_loops_(num_loops) {}

  /// Where node `i` is; each round is a little beside the one before.
  static Pose2 PoseOf(int i) {
    const double angle = 2.0 * M_PI * i / kNodesOfRound;
    const double radius = 1.0 + 0.02 * std::sin(0.37 * i / kNodesOfRound);
    return Pose2(40.0 * radius * std::cos(angle), 25.0 * radius * std::sin(2.0 * angle), angle);
  }

  Recording Build() const {
    ScanLog log;
    log.name = "large.log";
    log.beam_geometries = {{8, 0.0, M_PI / 4.0}};
    for (int i = 0; i < num_nodes_; ++i) {
      log.scans.push_back({0.2 * i, 0, std::vector<float>(8, 3.0f + 0.1f * (i % 7)), 0});
    }
    Recording recording(std::move(log), LoopscopePreset());
    for (int i = 0; i < num_nodes_; ++i) recording.Append(UpdateOf(i));
    return recording;
  }

  SlamUpdate UpdateOf(int i) const {
    const int num_submaps = i / kNodesOfHalfSubmap + 1;
    SlamUpdate update;
    update.step.local_from_base = PoseOf(i);
    update.step.outcome = StepOutcome::kInserted;
    update.step.node = NodeId{i};
    if (i % kNodesOfHalfSubmap == 0) update.started_submap = Submap{PoseOf(i), NodeId{i}, 0, -1};
    const int num_in = std::min(num_submaps, 2);
    update.node = Node{i, PoseOf(i), SubmapId{num_submaps - num_in}, num_in};
    if (i % kNodesOfHalfSubmap == kNodesOfHalfSubmap - 1 && num_in == 2) {
      update.finished_submap = SubmapId{num_submaps - 2};
    }
    if (i == num_nodes_ - 1) {
      for (int loop = 0; loop < num_loops_; ++loop) update.candidates.push_back(LoopOf(loop, i));
    }
    return update;
  }

  /// A node and a submap of another round at the same place, found some centimetres beside.
  LoopCandidate LoopOf(int loop, int step) const {
    const int node = static_cast<int>((7919LL * loop) % num_nodes_);
    const int other = (node + kNodesOfRound * (1 + loop % 5)) % num_nodes_;
    const int first = other / kNodesOfHalfSubmap * kNodesOfHalfSubmap;
    LoopCandidate candidate;
    candidate.submap = SubmapId{first / kNodesOfHalfSubmap};
    candidate.node = NodeId{node};
    candidate.applied_step = step;
    candidate.verdict = Verdict::kAccepted;
    candidate.score = 0.7;
    candidate.submap_from_node =
        PoseOf(first).Inverse() * PoseOf(node) * Pose2(0.01 * (loop % 11), 0.02, 0.0);
    return candidate;
  }

  int num_nodes_;
  int num_loops_;
};

}  // namespace loopscope
