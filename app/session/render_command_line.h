// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/view.h"

namespace loopscope {

/// The arguments of the program `loopscope` that draw the picture of `request` of the recording in
/// the file `run` into the file `output`.
std::vector<std::string> RenderArguments(const ViewRequest& request, const std::string& run,
                                         const std::string& output);

/// The same as a line for a POSIX shell.
std::string RenderCommandLine(const ViewRequest& request, const std::string& run,
                              const std::string& output);

}  // namespace loopscope
