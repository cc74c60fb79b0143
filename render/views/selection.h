// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/slam/recording.h"
#include "render/view.h"

namespace loopscope {

// What a request means in a recording. All throw std::invalid_argument, saying what was expected,
// if the recording does not have it; NothingToShow if it does at a later step.

void RequireNode(const Recording& recording, NodeId node);
void RequireSubmap(const Recording& recording, SubmapId submap);

/// The step asked for; else for update and match that of the node asked for; else the last one.
int StepOf(const Recording& recording, const ViewRequest& request);

/// The node asked for; else the last one that was inserted until StepOf.
NodeId NodeOf(const Recording& recording, const ViewRequest& request);

/// The submap asked for, which had begun by then; else the last one finished until StepOf, and if
/// there is none the last one begun.
SubmapId SubmapOf(const Recording& recording, const ViewRequest& request);

/// The submap of `node` that was asked for; else the older of its submaps.
SubmapId SubmapOfNode(const Recording& recording, const ViewRequest& request, NodeId node);

/// The pair asked for. If only one of the two is given, or none, the accepted loop candidate with
/// the highest score among those that fit and had been applied until StepOf; if none was accepted,
/// the searched one.
std::pair<SubmapId, NodeId> SearchedPairOf(const Recording& recording, const ViewRequest& request);

/// Run, step and time of a picture, and then `ids`.
std::vector<std::string> Subtitle(const Recording& recording, int step,
                                  const std::vector<std::string>& ids);

}  // namespace loopscope
