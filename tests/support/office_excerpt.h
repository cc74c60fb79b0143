// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/io/line_reader.h"

namespace loopscope {

/// The beginning of the bundled log, up to and with so many scans.
inline std::string OfficeExcerpt(int num_scans) {
  LineReader lines(LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz");
  std::string text;
  while (num_scans > 0) {
    const auto line = lines.Next();
    if (!line) break;
    text.append(*line).push_back('\n');
    if (line->substr(0, 6) == "FLASER") --num_scans;
  }
  return text;
}

}  // namespace loopscope
