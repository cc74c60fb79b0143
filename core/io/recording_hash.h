// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/slam/recording.h"

namespace loopscope {

/// A 64 bit FNV-1a hash of every value of a recording, bit for bit: log, options, and all steps.
/// Two runs that differ anywhere, be it in the last bit of a pose, have different ones.
std::uint64_t HashOfRecording(const Recording& recording);

}  // namespace loopscope
