// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// The path of a log without ".gz", and without the ".log" or ".clf" before it: what is made from
/// the log is named by it.
std::string LogStem(const std::string& log_path);

}  // namespace loopscope
