// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sensor/scan_log.h"

namespace loopscope {

/// A CARMEN log: PARAM lines with what old-style scans do not tell, an ODOM line for each odometry
/// reading, and after it the scans that it stands before. Scans of 180, 181, 360 or 361 beams over
/// half a turn become FLASER lines, others ROBOTLASER1 with explicit geometry. A beam without
/// return is written as 81.91, an invalid one as 0. Poses and stamps have 6 decimals, ranges as
/// many as give the same float again. A scan before the first odometry reading is left out.
std::string CarmenText(const ScanLog& log);

/// Writes CarmenText to `path`, as gzip if it ends in .gz. Throws FileError.
void WriteCarmenLog(const std::string& path, const ScanLog& log);

}  // namespace loopscope
