// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/constraint.h"
#include "core/graph/drift_share.h"
#include "core/graph/graph_state.h"

namespace loopscope {

/// What drift the loops took that were accepted.
class MeasuredDrift {
 public:
  MeasuredDrift(const MeasuredDriftOptions& options, const OutlierOptions& outliers)
      : options_(options), outliers_(outliers) {}

  /// `share` of its window, see DriftShareOf.
  void Note(const Constraint& loop, const DriftShare& share) { loops_.push_back({loop, share}); }

  /// Of the loops in force in `graph`.
  DriftShare Predict(const GraphState& graph) const;

 private:
  struct Loop {
    Constraint constraint;
    DriftShare share;
  };

  MeasuredDriftOptions options_;
  OutlierOptions outliers_;
  std::vector<Loop> loops_;
};

}  // namespace loopscope
