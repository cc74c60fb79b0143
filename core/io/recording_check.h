// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/slam/recording.h"

namespace loopscope {

/// What is wrong with a log that came out of a file: an index that leads nowhere, numbers that do
/// not fit each other. Nothing if all is well.
std::optional<std::string> FaultOf(const ScanLog& log);

/// What is wrong with `update` as the next step of `recording`, so that Recording::Append, and all
/// that goes by its indices, can rely on it. Nothing if all is well.
std::optional<std::string> FaultOf(const SlamUpdate& update, const Recording& recording);

}  // namespace loopscope
