// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/last_look.h"

#include <algorithm>

#include "core/graph/spa_cost.h"
#include "core/matching/match_score.h"

namespace loopscope {

double MinScoreOfLastLook(double min_loop_score, const PointCloud& points_in_node,
                          const Pose2& submap_from_node_guess, const ProbabilityGrid& grid,
                          const LastLookOptions& options) {
  const int num_known = ScoreOfKnown(points_in_node, submap_from_node_guess, grid).num_points;
  const double known_share = num_known / static_cast<double>(points_in_node.size());
  const double share = std::max(known_share, options.min_known_share);
  const double min_mean = options.min_score_factor * min_loop_score;
  return share * min_mean + (1.0 - share) * kMinProbability;
}

double RelativeScoreOfKnown(const PointCloud& points_in_node, const Pose2& submap_from_node,
                            const Pose2& submap_from_node_winner, const ProbabilityGrid& grid,
                            const LastLookOptions& options) {
  const KnownScore score = ScoreOfKnown(points_in_node, submap_from_node, grid);
  const KnownScore of_winner = ScoreOfKnown(points_in_node, submap_from_node_winner, grid);
  const double min_num_known = options.min_known_share * static_cast<double>(points_in_node.size());
  if (of_winner.num_points == 0 || score.num_points < min_num_known) return 0.0;
  return score.mean_probability / of_winner.mean_probability;
}

Eigen::Vector3d ResidualAtGuess(const LoopCandidate& found) {
  return SpaError(found.submap_from_node, Pose2(), found.submap_from_node_guess);
}

}  // namespace loopscope
