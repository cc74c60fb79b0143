// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/session/table.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// The loop candidates of a recording, one a row: row i is recording.candidates()[i], whatever step
/// is shown. It grows with the recording.
class LoopTable {
 public:
  LoopTable();

  const Table& table() const { return table_; }

  /// Adds rows for the candidates that the recording got since the last call.
  void Append(const Recording& recording);

  /// Fills the columns that depend on poses, `distance`, `residual` and `residual_angle`, with
  /// those of `state`; of candidates that had not been applied by then they are not known.
  void Show(const Recording& recording, const MapState& state);

 private:
  void SetDecision(int row, const LoopCandidate& candidate);
  void SetSearch(int row, const LoopCandidate& candidate);

  Table table_;
};

}  // namespace loopscope
