// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/loop_closures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/graph/loop_search.h"
#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"
#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

/// What the optimization makes of a loop with this residual [m, m, rad].
double WeightOf(const Eigen::Vector3d& residual, const PoseGraphOptions& options) {
  if (IsOutlier(residual, options.optimization_problem.outliers)) return 0.0;
  const Constraint constraint = ToConstraint(LoopCandidate(), options.constraint_builder);
  const Eigen::Vector3d weights(constraint.translation_weight, constraint.translation_weight,
                                constraint.rotation_weight);
  return HuberWeight(weights.cwiseProduct(residual).squaredNorm(),
                     options.optimization_problem.huber_scale);
}

/// The node of the submap that lies nearest to where the loop puts its own.
NodeId NearestNode(const Recording& recording, const LoopCandidate& loop,
                   const ReferencePoses& reference) {
  const Submap& submap = recording.submap(loop.submap);
  NodeId nearest{-1};
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (int i = submap.first_node.index; i < submap.first_node.index + submap.num_nodes; ++i) {
    if (!reference[i]) continue;
    const Pose2 submap_from_node = SubmapFromNode(recording, loop.submap, NodeId{i});
    const double distance =
        (submap_from_node.translation - loop.submap_from_node.translation).norm();
    if (distance >= nearest_distance) continue;
    nearest = NodeId{i};
    nearest_distance = distance;
  }
  return nearest;
}

std::optional<Pose2> ErrorOf(const Recording& recording, const LoopCandidate& loop,
                             const ReferencePoses& reference) {
  if (reference.empty() || !reference[loop.node.index]) return std::nullopt;
  const NodeId nearest = NearestNode(recording, loop, reference);
  if (nearest.index < 0) return std::nullopt;
  const Pose2 nearest_from_node =
      SubmapFromNode(recording, loop.submap, nearest).Inverse() * loop.submap_from_node;
  const Pose2 expected = reference[nearest.index]->Inverse() * *reference[loop.node.index];
  return expected.Inverse() * nearest_from_node;
}

}  // namespace

ReferencePoses ReferencePosesOfNodes(const Recording& recording, const Trajectory& reference) {
  ReferencePoses poses;
  for (const Node& node : recording.nodes()) {
    const double time = recording.log().scans[node.step].time;
    const bool is_covered =
        !reference.empty() && reference.front().time <= time && time <= reference.back().time;
    poses.push_back(is_covered ? std::optional(PoseAt(reference, time)) : std::nullopt);
  }
  return poses;
}

bool IsWithin(const Pose2& error, const LoopTolerance& tolerance) {
  return error.translation.norm() <= tolerance.translation &&
         std::abs(error.rotation) <= tolerance.rotation;
}

bool IsWrong(const JudgedLoop& loop, const LoopTolerance& tolerance) {
  return loop.error && !IsWithin(*loop.error, tolerance);
}

std::vector<JudgedLoop> JudgeLoops(const Recording& recording, const MapState& state,
                                   const ReferencePoses& reference) {
  std::vector<JudgedLoop> loops;
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.verdict != Verdict::kAccepted) continue;
    const Eigen::Vector3d residual = LoopResidual(state, candidate);
    const OutlierOptions& outliers = recording.options().pose_graph.optimization_problem.outliers;
    const double weight = WeightOf(residual, recording.options().pose_graph);
    const bool is_outlier =
        outliers.max_distance > 0.0 ? IsOutlier(residual, outliers) : weight < 0.5;
    loops.push_back({candidate.submap, candidate.node, candidate.submap_from_node, residual, weight,
                     is_outlier, ErrorOf(recording, candidate, reference)});
  }
  return loops;
}

LoopCounts CountLoops(const std::vector<JudgedLoop>& loops, const LoopTolerance& tolerance) {
  LoopCounts counts;
  counts.all = static_cast<int>(loops.size());
  for (const JudgedLoop& loop : loops) {
    const Pose2 residual(loop.residual.x(), loop.residual.y(), loop.residual.z());
    if (IsWithin(residual, kPaperTolerance)) ++counts.self_consistent;
    if (!loop.IsInForce()) continue;
    ++counts.in_force;
    if (!loop.error) continue;
    ++counts.judged;
    if (!IsWrong(loop, tolerance)) ++counts.correct;
  }
  return counts;
}

}  // namespace loopscope
