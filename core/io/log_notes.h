// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/sensor/scan_log.h"

namespace loopscope {

/// Gathers what a reader wants to tell, one note for each `what`, in the order of first sight.
class LogNotes {
 public:
  void Add(const std::string& what, int line, int count = 1);

  const std::vector<LogNote>& notes() const { return notes_; }

 private:
  std::vector<LogNote> notes_;
};

}  // namespace loopscope
