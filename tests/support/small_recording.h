// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/slam/recording.h"

namespace loopscope {

/// A run that no mapper made: consistent, with something of everything that a recording can hold,
/// and numbers that use all of their bits.
class SmallRun {
 public:
  explicit SmallRun(int num_scans, unsigned seed = 1) : random_(seed) {
    log_.name = "small.log";
    log_.base_from_laser = AnyPose();
    log_.beam_geometries = {{5, -1.0, 0.5}, {3, Any(), 0.1}};
    log_.notes = {{"lines of unknown kind, skipped", 3, 17}};
    for (int scan = 0; scan < num_scans; ++scan) AddScan(scan);
    for (int step = 0; step < num_scans; ++step) updates_.push_back(MakeUpdate(step));
  }

  const ScanLog& log() const { return log_; }
  const std::vector<SlamUpdate>& updates() const { return updates_; }

  Recording ToRecording() const {
    Recording recording(log_, CartographerPreset());
    for (const SlamUpdate& update : updates_) recording.Append(update);
    return recording;
  }

 private:
  double Any() { return std::uniform_real_distribution<>(-10.0, 10.0)(random_); }
  double Share() { return 0.05 * (Any() + 10.0); }
  Pose2 AnyPose() { return Pose2(Any(), Any(), Any() / 4.0); }

  void AddScan(int scan) {
    log_.odometry.push_back({1e9 + 0.1 * scan, AnyPose()});
    LaserScan laser_scan;
    laser_scan.time = 1e9 + 0.1 * scan + 0.05;
    laser_scan.beam_geometry = scan % 3 == 2 ? 1 : 0;
    laser_scan.num_odometry_before = static_cast<int>(log_.odometry.size());
    for (int i = 0; i < log_.beam_geometries[laser_scan.beam_geometry].num_beams; ++i) {
      laser_scan.ranges.push_back(static_cast<float>(std::round(100.0 * (Any() + 10.5)) / 100.0));
    }
    laser_scan.ranges[scan % 3] = std::numeric_limits<float>::infinity();
    laser_scan.ranges[(scan + 1) % 3] = std::numeric_limits<float>::quiet_NaN();
    log_.scans.push_back(laser_scan);
  }

  /// Every third scan becomes no node; submaps are begun every 4 nodes, and finished after 8.
  SlamUpdate MakeUpdate(int step) {
    SlamUpdate update;
    update.step.local_from_base_prior = AnyPose();
    if (step % 2 == 1) update.step.local_from_base_correlative = AnyPose();
    update.step.local_from_base = AnyPose();
    update.step.wide_walls = step % 3 == 0;
    if (step % 7 != 0) update.step.match_start = static_cast<MatchStart>(step % 6);
    update.step.outcome = step % 6 == 2 ? StepOutcome::kNoReturns : StepOutcome::kMotionFiltered;
    if (step % 3 != 2) AddNode(step, &update);
    if (step % 5 == 4 && num_submaps_ > 1) {
      for (int i = 0; i < 4; ++i) update.candidates.push_back(MakeCandidate(step, i));
      update.optimization = MakeOptimization(step);
    }
    return update;
  }

  void AddNode(int step, SlamUpdate* update) {
    update->step.outcome = StepOutcome::kInserted;
    update->step.node = NodeId{num_nodes_};
    if (num_nodes_ % 4 == 0) {
      update->started_submap = Submap{AnyPose(), NodeId{num_nodes_}, 0, -1};
      ++num_submaps_;
    }
    // Of some nodes the pose is not that of the step, which no mapper of today does.
    const Pose2 pose = num_nodes_ % 5 == 3 ? AnyPose() : update->step.local_from_base;
    const int num_in = num_submaps_ > 1 ? 2 : 1;
    update->node = Node{step, pose, SubmapId{num_submaps_ - num_in}, num_in};
    ++num_nodes_;
    if (num_submaps_ > 1 && num_nodes_ % 4 == 0) {
      update->finished_submap = SubmapId{num_submaps_ - 2};
    }
  }

  LoopCandidate MakeCandidate(int step, int index) {
    LoopCandidate candidate;
    // Of those that were there three steps before.
    candidate.submap = SubmapId{index % (num_submaps_ - 1)};
    candidate.node = NodeId{step % (num_nodes_ - 3)};
    candidate.considered_step = step - index;
    candidate.applied_step = step;
    if (index % 2 == 0) return candidate;  // not sampled
    candidate.whole_submap = index == 3;
    candidate.last_look = index == 1;
    candidate.submap_from_node_guess = AnyPose();
    candidate.verdict = kRecordedVerdicts[(step + index) / 2 % kRecordedVerdicts.size()];
    candidate.score = Any();
    candidate.score_bound = Any();
    candidate.min_score = Any();
    candidate.rival_score = Any();
    candidate.num_supporters = step;
    candidate.linear_search_window = std::abs(Any());
    candidate.angular_search_window = 0.2 * std::abs(Any());
    candidate.submap_from_node_searched = AnyPose();
    candidate.submap_from_node = Pose2(0.0, -0.0, 1.0);  // zeros have signs
    return candidate;
  }

  Optimization MakeOptimization(int step) {
    Optimization optimization;
    optimization.step = step;
    optimization.final = step % 10 == 9;
    for (int i = 0; i < num_submaps_; ++i) optimization.global_from_submap.push_back(AnyPose());
    for (int i = 0; i < num_nodes_; ++i) optimization.global_from_node.push_back(AnyPose());
    optimization.num_iterations = step;
    optimization.initial_cost = Any();
    optimization.final_cost = Any();
    optimization.drift_share = {Share(), Share()};
    return optimization;
  }

  std::mt19937 random_;
  ScanLog log_;
  std::vector<SlamUpdate> updates_;
  int num_nodes_ = 0;
  int num_submaps_ = 0;
};

}  // namespace loopscope
