// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "core/io/carmen_log.h"
#include "core/io/file_error.h"
#include "tests/fuzz/memory_file.h"

// Whatever a log holds: it is read, with scans and odometry that fit together, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const loopscope::MemoryFile file(data, size);
  try {
    const loopscope::ScanLog log = loopscope::ReadCarmenLog(file.path());
    for (const loopscope::LaserScan& scan : log.scans) {
      const auto& beams = log.beam_geometries.at(scan.beam_geometry);
      if (beams.num_beams != static_cast<int>(scan.ranges.size())) std::abort();
      if (scan.num_odometry_before > static_cast<int>(log.odometry.size())) std::abort();
    }
  } catch (const loopscope::FileError&) {
    return 0;
  }
  return 0;
}
