// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// Something that is known, such as "score" and "0.612".
struct ReportRow {
  std::string name;
  std::string value;       ///< with unit
  std::string expected;    ///< by a gate, e.g. "more than 0.550"; empty if there is nothing to fail
  bool passed = true;      ///< the gate
  std::string exact = "";  ///< an option's value with all its digits
};

/// Rows that belong together.
struct Section {
  std::string title;
  std::vector<ReportRow> rows;
};

using InspectionReport = std::vector<Section>;

// Everything known about a selection, with the poses and residuals of `state`. They throw
// std::invalid_argument that says which there are if the recording does not have what is asked for.

/// The scan of state.step, what was made of it and what it caused.
InspectionReport ReportOnStep(const Recording& recording, const MapState& state);
InspectionReport ReportOnNode(const Recording& recording, const MapState& state, NodeId node);
InspectionReport ReportOnSubmap(const Recording& recording, const MapState& state, SubmapId submap);

/// A pair of submap and node, with the gates that it went through. It takes some 50 ms in a long
/// run, and several times that for a pair that was not searched, which is searched now.
InspectionReport ReportOnPair(const Recording& recording, const MapState& state, SubmapId submap,
                              NodeId node);

// What takes long, for a worker thread.

/// How well the scan of `step` fits where it was predicted and where it was matched: grows the grid
/// of a submap anew.
Section ReportOnMatch(const Recording& recording, int step);

/// Uncertainty of a pose in the global frame in `state`, given that submap 0 is where it is: solves
/// for a covariance in the whole graph. Throws if the node or submap does not exist in `state`.
Section ReportOnCovariance(const Recording& recording, const MapState& state, NodeId node);
Section ReportOnCovariance(const Recording& recording, const MapState& state, SubmapId submap);

}  // namespace loopscope
