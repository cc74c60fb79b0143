// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/slam/recording.h"

namespace CLI {
class App;
}

namespace loopscope {

/// Adds the positional argument RUN, a recording to read.
void AddRunArgument(CLI::App* command, std::string* run);

/// A node or submap that the user named by its index. Throws std::invalid_argument that says which
/// there are if it is not one of the recording's.
NodeId NodeOf(const Recording& recording, int index);
SubmapId SubmapOf(const Recording& recording, int index);

}  // namespace loopscope
