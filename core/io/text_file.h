// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// All of a small text file. Throws FileError if it cannot be read or has more than 1 MB.
std::string ReadTextFile(const std::string& path);

}  // namespace loopscope
