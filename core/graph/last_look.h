// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/graph/loop_candidate.h"
#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.last_look, not in Cartographer: after the final optimization all
/// submaps of one place, see SecondLookOptions, that no loop ties are searched once more where the
/// map has them, in the least window. Few poses in it could match by chance, so that less has to
/// match; but what is found off the map by more than its loops may be, see OutlierOptions, is none.
struct LastLookOptions {
  int num_nodes = 0;              ///< that are searched in a submap of the same place; 0: off
  double min_score_factor = 1.0;  ///< of the score that a loop must beat otherwise
  /// Points count that lie in cells that the submap knows where the map has the node, and so many
  /// at least, as a share: of what is seen from the edge of a submap half lies beyond. 1: all.
  double min_known_share = 1.0;
};

/// What the score has to beat in a last look, if it has to beat `min_loop_score` otherwise: as much
/// as if the points that count had a mean probability of min_score_factor * min_loop_score, and
/// the others none. `points_in_node` must not be empty.
double MinScoreOfLastLook(double min_loop_score, const PointCloud& points_in_node,
                          const Pose2& submap_from_node_guess, const ProbabilityGrid& grid,
                          const LastLookOptions& options);

/// How well the points that the submap knows match at a pose, in shares of how well those match
/// that it knows at the winner. 0 if it knows fewer of them than min_known_share.
double RelativeScoreOfKnown(const PointCloud& points_in_node, const Pose2& submap_from_node,
                            const Pose2& submap_from_node_winner, const ProbabilityGrid& grid,
                            const LastLookOptions& options);

/// By how much a loop is off where the map had the node: the residual of eq. 5 [m, m, rad] there.
Eigen::Vector3d ResidualAtGuess(const LoopCandidate& found);

}  // namespace loopscope
