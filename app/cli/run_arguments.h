// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace CLI {
class App;
}  // namespace CLI

namespace loopscope {

/// Adds the positional argument RUN, a recording to read.
void AddRunArgument(CLI::App* command, std::string* run);

/// A check of an option: what is wrong with a text that is no number, or "nan"; else empty.
std::string RefuseNan(const std::string& text);

/// Reads a recording that has at least one step, so that there is something to show. Throws
/// FileError.
Recording ReadRun(const std::string& path);

/// The state after `step`, or after the last one. Throws std::invalid_argument that says which
/// steps there are if it is not one of the recording's.
MapState StateOf(const Recording& recording, std::optional<int> step);

/// A node or submap that the user named by its index. Throws std::invalid_argument that says which
/// there are if it is not one of the recording's.
NodeId NodeOf(const Recording& recording, int index);
SubmapId SubmapOf(const Recording& recording, int index);

}  // namespace loopscope
