// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string>

#include <sys/wait.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {

/// What a program said and how it ended.
struct ProgramRun {
  int exit_code = -1;  ///< -1 if a signal ended it
  std::string out;
  std::string err;
};

/// Runs `loopscope` with `arguments` in a shell, without a display, in `folder`.
inline ProgramRun RunLoopscope(const TemporaryFolder& folder, const std::string& arguments,
                               const std::string& before = "") {
  const std::string out = folder.Path("stdout.txt");
  const std::string err = folder.Path("stderr.txt");
  const std::string command = "cd '" + folder.Path("") + "' && unset DISPLAY && " + before + " '" +
                              LOOPSCOPE_BINARY_DIR "/bin/loopscope' " + arguments + " > '" + out +
                              "' 2> '" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ContentOf(out), ContentOf(err)};
}

}  // namespace loopscope
