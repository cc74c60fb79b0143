// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "app/mapping.h"

namespace loopscope {

/// Shows on stderr how far long work has come: a bar on a terminal, else a line for every tenth.
class ProgressBar {
 public:
  ProgressBar();
  /// Ends it, so that an error has a line of its own.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(const MappingProgress& progress);
  /// `done` of `total` > 0 parts of the work, and `what` these are.
  void Show(int done, int total, const std::string& what);
  /// Leaves what was shown last, and ends the line.
  void End();

  double seconds() const;  ///< since the bar was made

 private:
  bool is_terminal_;
  bool has_ended_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_shown_;
  int last_tenth_ = 0;
};

/// While one lives, Ctrl-C does not end the process but is remembered.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static bool interrupted();
};

}  // namespace loopscope
