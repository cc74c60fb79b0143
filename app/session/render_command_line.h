// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/view.h"

namespace loopscope {

/// The arguments of the program `loopscope` that draw the picture of `request` of the recording in
/// the file `run` into the file `output`, byte for byte. What the request leaves out is left out.
/// Throws std::invalid_argument if it asks for no layer at all, which no command line can say.
std::vector<std::string> RenderArguments(const std::string& run, const ViewRequest& request,
                                         const std::string& output);

/// The same as one line for a POSIX shell.
std::string RenderCommandLine(const std::string& run, const ViewRequest& request,
                              const std::string& output);

/// `word` as one word of a POSIX shell, in quotes if it needs them.
std::string QuotedForShell(const std::string& word);

}  // namespace loopscope
