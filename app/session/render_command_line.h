// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/view.h"

namespace loopscope {

/// The command that draws the very picture of `request` without a display, for a POSIX shell:
/// "loopscope render RUN --view graph --step 812 -o OUTPUT". What the request leaves to the view is
/// left out, and so are size and theme if they are the usual ones. Throws std::invalid_argument if
/// the command line cannot say it: no layers at all.
std::string RenderCommandLine(const std::string& run, const ViewRequest& request,
                              const std::string& output);

/// `word` as one word of a POSIX shell, in quotes if it needs them.
std::string QuotedForShell(const std::string& word);

}  // namespace loopscope
