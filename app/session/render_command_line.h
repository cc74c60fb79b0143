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

/// Which pictures make a film: every `stride`-th step.
struct FilmSteps {
  int first = 0;
  int last = 0;
  int stride = 1;
  double frames_per_second = 25.0;
};

/// The words behind `loopscope` that make a film of the picture of `request` over these steps,
/// whatever its own step is; as RenderArguments does it.
std::vector<std::string> FilmArguments(const std::string& run, const ViewRequest& request,
                                       const FilmSteps& steps, const std::string& output);

/// `loopscope` with these arguments as one line for a POSIX shell.
std::string CommandLine(const std::vector<std::string>& arguments);

/// `word` as one word of a POSIX shell, in quotes if it needs them.
std::string QuotedForShell(const std::string& word);

}  // namespace loopscope
