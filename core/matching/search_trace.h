// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/pose2.h"
#include "core/grid/cell.h"

namespace loopscope {

/// The window W of eqs. 8 to 10: poses guess + (r j_x, r j_y, delta j_theta) with
/// |j_x|, |j_y| <= num_linear_steps and |j_theta| <= num_angular_steps.
struct SearchWindow {
  Pose2 submap_from_scan_guess;  ///< xi_0
  int num_linear_steps = 0;      ///< w_x = w_y, in cells
  int num_angular_steps = 0;     ///< w_theta
  double resolution = 0.0;       ///< r [m]
  double angular_step = 0.0;     ///< delta_theta [rad], eq. 7
};

/// What became of a node of the branch and bound.
enum class SearchFate {
  kExpanded,  ///< its bound beat the best score, its children were scored
  kPruned,    ///< its bound did not beat the best score (or min_score)
  kImproved,  ///< a leaf that became the best so far
};

/// A node c of the search tree: the block of poses [x, x + 2^height) x [y, y + 2^height) x {angle}
/// of the window (eqs. 11, 12), and the upper bound of the score of every pose in it (eqs. 15, 16).
struct SearchNode {
  int parent = -1;      ///< index into SearchTrace::nodes, -1 for a start node
  int height = 0;       ///< c_h; 0 is a single pose, whose bound is its score
  CellIndex offset;     ///< lower corner (c_x, c_y) of the block [cells] relative to the guess
  int angle_index = 0;  ///< c_theta, in [-num_angular_steps, num_angular_steps]
  double bound = 0.0;   ///< the last one, in [kMinProbability, kMaxProbability]: some are refined
  double best_before = 0.0;  ///< the best score when its fate was decided
  SearchFate fate = SearchFate::kPruned;
};

/// What a search did, if it was asked to remember. Nodes stand in the order in which they were
/// scored; `visits` holds their indices in the order in which their fates were decided.
struct SearchTrace {
  SearchWindow window;
  std::vector<SearchNode> nodes;
  std::vector<int> visits;
  int winner = -1;  ///< index of the leaf that won, -1 if none beat min_score
};

}  // namespace loopscope
