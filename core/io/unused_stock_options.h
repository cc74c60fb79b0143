// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/io/config_value.h"

namespace loopscope {

/// What Cartographer's stock files (at 877157a0) set and Loopscope has no use for: options of 3D,
/// of sensors that it does not read, and of how Cartographer runs.
std::vector<ConfigEntry> UnusedStockOptions();

}  // namespace loopscope
