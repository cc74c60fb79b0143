// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/log_notes.h"

#include <algorithm>

namespace loopscope {

void LogNotes::Add(const std::string& what, int line, int count) {
  const auto same = std::find_if(notes_.begin(), notes_.end(),
                                 [&](const LogNote& note) { return note.what == what; });
  if (same != notes_.end()) {
    same->count += count;
  } else {
    notes_.push_back({what, count, line});
  }
}

}  // namespace loopscope
