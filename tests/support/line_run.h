// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/slam/recording.h"

namespace loopscope {

/// Where node `i` of 24 is: at 0, 1, ..., 11 m along x and then back again, sideways like a crab.
inline Pose2 LinePose(int i) { return Pose2(i < 12 ? i : 23 - i, 0.0, 0.0); }

/// A loop between a submap and a node of LineRun that is wrong by `error`, seen from the node.
inline LoopCandidate LineLoop(int submap, int node, const Pose2& error) {
  LoopCandidate loop;
  loop.submap = SubmapId{submap};
  loop.node = NodeId{node};
  loop.verdict = Verdict::kAccepted;
  loop.applied_step = loop.considered_step = 23;
  loop.submap_from_node = LinePose(4 * submap).Inverse() * LinePose(node) * error;
  return loop;
}

/// A run that no mapper made, without any error, along a corridor of 2 m: node i is at LinePose(i)
/// at time i, and in submap i / 4, which has the pose of its first node; all but the last have
/// finished. Each scan has a return to the left and one to the right.
inline Recording LineRun(const std::vector<LoopCandidate>& loops,
                         const Options& options = LoopscopePreset()) {
  ScanLog log;
  log.name = "line.log";
  log.beam_geometries = {{2, DegreesToRadians(-90.0), DegreesToRadians(180.0)}};
  for (int i = 0; i < 24; ++i) log.scans.push_back({1.0 * i, 0, {1.0f, 1.0f}, 0});
  Recording recording(log, options);
  for (int i = 0; i < 24; ++i) {
    SlamUpdate update;
    update.step.local_from_base_prior = update.step.local_from_base = LinePose(i);
    update.step.outcome = StepOutcome::kInserted;
    update.step.node = NodeId{i};
    if (i % 4 == 0) update.started_submap = Submap{LinePose(i), NodeId{i}, 0, -1};
    update.node = Node{i, LinePose(i), SubmapId{i / 4}, 1};
    if (i % 4 == 3 && i < 23) update.finished_submap = SubmapId{i / 4};
    if (i == 23) update.candidates = loops;
    recording.Append(update);
  }
  return recording;
}

/// The true way of LineRun, in another frame.
inline Trajectory LineReference() {
  Trajectory reference;
  for (int i = 0; i < 24; ++i) reference.push_back({1.0 * i, Pose2(5.0, 3.0, 2.0) * LinePose(i)});
  return reference;
}

}  // namespace loopscope
