// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"

namespace loopscope {

/// Why a pair of node and submap became a constraint or did not.
enum class Verdict {
  kTooFar,      ///< farther apart than max_constraint_distance; not stored, follows from the state
  kNotSampled,  ///< skipped by sampling_ratio
  kBelowMinScore,  ///< no pose of the window scored min_score
  kAmbiguous,      ///< another place in the window matches nearly as well
  kInconsistent,   ///< too few other loops agree with it, or, in a last look, the map does not
  kAccepted,       ///< INTER_SUBMAP constraint
  kFromBehind,     ///< it lies on walls that the submap knows from the other side only
};

/// Those that a recording can hold, the most interesting ones first.
constexpr std::array<Verdict, 6> kRecordedVerdicts = {
    Verdict::kAccepted,   Verdict::kInconsistent,  Verdict::kAmbiguous,
    Verdict::kFromBehind, Verdict::kBelowMinScore, Verdict::kNotSampled};

/// Whether something was found that scores enough, but was not believed.
constexpr bool IsRefused(Verdict verdict) {
  return verdict == Verdict::kAmbiguous || verdict == Verdict::kFromBehind ||
         verdict == Verdict::kInconsistent;
}

/// Whether the search found a place that scores enough, believed or not.
constexpr bool IsFound(Verdict verdict) {
  return verdict == Verdict::kAccepted || IsRefused(verdict);
}

/// A pair of a node and a finished submap that came up for a loop search. Of one that was not
/// sampled, only ids, steps and verdict are set.
struct LoopCandidate {
  SubmapId submap;
  NodeId node;
  int considered_step = 0;    ///< the scan after which it came up
  int applied_step = 0;       ///< the scan after which the result entered the graph
  bool whole_submap = false;  ///< searched everywhere in the submap instead of in the window
  bool last_look = false;     ///< searched after the final optimization, see LastLookOptions
  double linear_search_window = 0.0;   ///< W_x = W_y [m]
  double angular_search_window = 0.0;  ///< W_theta [rad]
  Pose2 submap_from_node_guess;        ///< from the poses then
  Verdict verdict = Verdict::kNotSampled;
  /// Of the winner, or the best that was found below min_score; in [0.1, 0.9]. 0 if not searched.
  double score = 0.0;
  /// No pose in the window scores more. 0 if not searched.
  double score_bound = 0.0;
  double min_score = 0.0;  ///< what the score had to beat
  /// Of a place far from the winner that matches nearly as well; 0: none. Where the guess of a last
  /// look is one, its score of what is known, in shares of the winner's, times `score`.
  double rival_score = 0.0;
  int num_supporters = 0;           ///< nodes with loops that agree, see LoopConsistencyOptions
  Pose2 submap_from_node_searched;  ///< where the search found `score`
  Pose2 submap_from_node;           ///< refined by (CS): the constraint, if accepted
};

/// Where the search found the node, seen from the guess.
inline Pose2 Moved(const LoopCandidate& searched) {
  return searched.submap_from_node_guess.Inverse() * searched.submap_from_node_searched;
}

}  // namespace loopscope
