// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace loopscope {

/// Runs a line of a command.
using RunLine = std::function<void(const std::string& line)>;

}  // namespace loopscope
