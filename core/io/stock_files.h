// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace loopscope {

/// Lua text that sets all that Cartographer's stock file of this name sets, e.g. "pose_graph.lua",
/// and includes what it includes; nothing if there is no stock file of this name. Options that
/// Loopscope adds are set as in CartographerPreset().
std::optional<std::string> StockFile(const std::string& name);

}  // namespace loopscope
