// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/session/timeline.h"
#include "core/slam/recording.h"

namespace loopscope {

/// When to stop playing.
struct PauseConditions {
  bool on_loop = false;       ///< a loop was closed
  bool on_rejection = false;  ///< a loop was refused as ambiguous or inconsistent
  /// [m] A loop was closed that was farther off than this in the poses before the optimization that
  /// it set off.
  std::optional<double> residual_above;
};

/// The event of `step`, in [0, recording.num_steps()), at which to pause: of the loops that are too
/// far off the one that is so most, else the first loop closed, else the first refused. Nothing if
/// playing goes on.
std::optional<Event> ShouldPause(const Recording& recording, int step,
                                 const PauseConditions& conditions);

}  // namespace loopscope
