// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/loop_candidate.h"
#include "core/graph/loop_gate.h"

namespace loopscope {

/// A drift as a share of the windows that a gate allows for it.
struct DriftShare {
  double linear = 1.0;
  double angular = 1.0;
};

/// `part` of `window` as a share; all of a window that is none.
double ShareOfWindow(double part, double window);

/// What share of the windows of `gate` it takes to get from `guess` to where the loop is; both
/// submap_from_node.
DriftShare DriftShareOf(const Pose2& guess, const Pose2& found, const LoopGate& gate);

/// The share of their windows in which the next searches will find their loops, of what loops in
/// force took until now: three times what all but one in twenty took, within the limits of
/// `options`. All of the windows while loops are few. An innovation gate whose variance is
/// measured; Bar-Shalom et al., "Estimation with Applications to Tracking and Navigation", 2001.
DriftShare PredictDriftShare(const std::vector<DriftShare>& taken,
                             const MeasuredDriftOptions& options);

/// The candidate with so much of its windows, but all of them for every eighth node: so that a
/// drift that grows is noticed.
LoopCandidate WithDriftShare(LoopCandidate candidate, const DriftShare& share);

}  // namespace loopscope
