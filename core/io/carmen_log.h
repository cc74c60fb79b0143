// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sensor/scan_log.h"

namespace loopscope {

/// Reads a log of the CARMEN robot navigation toolkit, plain or gzip. Real ones are dirty: lines
/// that make no sense are skipped, and everything that was corrected, left out or assumed is told
/// in ScanLog::notes.
///
/// Scans are those of one scanner (FLASER, ROBOTLASERn, RAWLASERn, or else RLASER); its place is
/// that of the laser's poses in the lines where they keep the same distance from the robot's, else
/// that of PARAM robot_frontlaser_offset. The pose of the robot in a scan's line is an odometry
/// reading that stands before the scan, unless it repeats the one before. Poses that never change
/// are no odometry.
///
/// Throws FileError if the file cannot be read, has no scan, or would not fit in memory.
ScanLog ReadCarmenLog(const std::string& path);

}  // namespace loopscope
