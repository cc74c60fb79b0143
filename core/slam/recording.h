// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/drift_share.h"
#include "core/graph/loop_candidate.h"
#include "core/local/match_start.h"
#include "core/sensor/scan_log.h"
#include "core/slam/options.h"

namespace loopscope {

/// What became of a scan.
enum class StepOutcome {
  kInserted,        ///< it became a node
  kMotionFiltered,  ///< matched, but too near to the node before it
  kNoReturns,       ///< nothing in range to match with: the pose is the extrapolated one
};

/// What local SLAM made of one scan. Step k is about scan k of the log.
struct Step {
  Pose2 local_from_base_prior;                       ///< extrapolated, before any matching
  std::optional<Pose2> local_from_base_correlative;  ///< after the correlative matcher, if it ran
  Pose2 local_from_base;                             ///< after (CS)
  StepOutcome outcome = StepOutcome::kNoReturns;
  std::optional<MatchStart> match_start;  ///< unless an older Loopscope made the recording
  bool wide_walls = false;     ///< it was matched WithWideWalls; older recordings do not tell
  std::optional<NodeId> node;  ///< set if inserted
};

/// A scan that was inserted. Its pose in each of its submaps is the INTRA_SUBMAP constraint.
struct Node {
  int step = 0;
  Pose2 local_from_base;
  SubmapId
      first_submap;  ///< it went into the submaps first_submap ... first_submap + num_submaps - 1
  int num_submaps = 0;  ///< 1 or 2

  bool LiesIn(SubmapId submap) const {
    return submap.index >= first_submap.index && submap.index < first_submap.index + num_submaps;
  }
};

struct Submap {
  Pose2 local_from_submap;
  NodeId first_node;       ///< its nodes are first_node ... first_node + num_nodes - 1
  int num_nodes = 0;       ///< so far
  int finished_step = -1;  ///< -1 while it still grows
};

/// The poses that an optimization (SPA) gave.
struct Optimization {
  int step = 0;  ///< the scan after which it ran
  bool final = false;
  std::vector<Pose2> global_from_submap;  ///< for all submaps that were there
  std::vector<Pose2> global_from_node;    ///< for all nodes that were there
  int num_iterations = 0;
  double initial_cost = 0.0;  ///< half of eq. 4 with the loops that were left at the end
  double final_cost = 0.0;
  DriftShare drift_share{};  ///< of their windows that searches take from then on
};

/// All that one scan caused, in the order of the fields.
struct SlamUpdate {
  Step step;
  std::optional<Submap> started_submap;      ///< begun before the node was inserted; still empty
  std::optional<Node> node;                  ///< inserted
  std::optional<SubmapId> finished_submap;   ///< which the node completed
  std::vector<LoopCandidate> candidates;     ///< applied now
  std::optional<Optimization> optimization;  ///< made with them
};

/// Inputs and decisions of a run: everything else follows from them (see derive.h).
class Recording {
 public:
  Recording(ScanLog log, Options options)
      : log_(std::make_shared<const ScanLog>(std::move(log))), options_(std::move(options)) {}

  const ScanLog& log() const { return *log_; }
  const Options& options() const { return options_; }

  /// Makes room for so many, so that adding them moves none of those before.
  void ReserveCandidates(std::size_t count) { candidates_.reserve(count); }

  /// Adds what the next scan caused.
  void Append(SlamUpdate update);

  /// Number of scans mapped so far; it is less than the scans of the log after an interrupted run.
  int num_steps() const { return static_cast<int>(steps_.size()); }
  const Step& step(int step) const { return steps_[step]; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Submap>& submaps() const { return submaps_; }
  const Node& node(NodeId id) const { return nodes_[id.index]; }
  const Submap& submap(SubmapId id) const { return submaps_[id.index]; }

  /// In the order in which they were applied.
  const std::vector<LoopCandidate>& candidates() const { return candidates_; }
  /// Index of the last candidate of a pair, which comes up again if it gets a second look, among
  /// the first `num_candidates`; nothing if there is none.
  std::optional<int> FindCandidate(SubmapId submap, NodeId node, int num_candidates) const;
  /// Likewise, among all.
  std::optional<int> FindCandidate(SubmapId submap, NodeId node) const;

  const std::vector<Optimization>& optimizations() const { return optimizations_; }

 private:
  std::shared_ptr<const ScanLog> log_;  // the large part, which copies share
  Options options_;
  std::vector<Step> steps_;
  std::vector<Node> nodes_;
  std::vector<Submap> submaps_;
  std::vector<LoopCandidate> candidates_;
  std::vector<Optimization> optimizations_;
};

}  // namespace loopscope
