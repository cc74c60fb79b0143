// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/pause.h"

#include <algorithm>

#include "core/slam/loop_explanation.h"
#include "core/slam/state.h"

namespace loopscope {
namespace {

/// Indices of the candidates that were applied at `step` with a verdict that `is_wanted`.
template <typename Predicate>
std::vector<int> AppliedAtStep(const Recording& recording, int step, const Predicate& is_wanted) {
  const auto& candidates = recording.candidates();
  const auto begin = std::partition_point(
      candidates.begin(), candidates.end(),
      [&](const LoopCandidate& candidate) { return candidate.applied_step < step; });
  std::vector<int> found;
  for (auto it = begin; it != candidates.end() && it->applied_step == step; ++it) {
    if (is_wanted(it->verdict)) found.push_back(static_cast<int>(it - candidates.begin()));
  }
  return found;
}

struct FarthestLoop {
  int candidate = 0;
  double residual = 0.0;  ///< [m]
};

/// Of the loops closed at `step`, before the optimization; there must be one.
FarthestLoop FindFarthest(const Recording& recording, int step, const std::vector<int>& loops) {
  const MapState state = StateBeforeOptimization(recording, step);
  FarthestLoop farthest{loops.front(), 0.0};
  for (const int loop : loops) {
    const double residual = LoopResidual(state, recording.candidates()[loop]).head<2>().norm();
    if (residual > farthest.residual) farthest = {loop, residual};
  }
  return farthest;
}

}  // namespace

std::optional<Event> ShouldPause(const Recording& recording, int step,
                                 const PauseConditions& conditions) {
  const std::vector<int> closed =
      AppliedAtStep(recording, step, [](Verdict verdict) { return verdict == Verdict::kAccepted; });
  if (conditions.residual_above && !closed.empty()) {
    const FarthestLoop farthest = FindFarthest(recording, step, closed);
    if (farthest.residual > *conditions.residual_above) {
      return Event{step, Event::Kind::kLoopClosed, farthest.candidate};
    }
  }
  if (conditions.on_loop && !closed.empty()) {
    return Event{step, Event::Kind::kLoopClosed, closed.front()};
  }
  const std::vector<int> refused = AppliedAtStep(recording, step, IsRefused);
  if (conditions.on_rejection && !refused.empty()) {
    return Event{step, Event::Kind::kLoopRefused, refused.front()};
  }
  return std::nullopt;
}

}  // namespace loopscope
