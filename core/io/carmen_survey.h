// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "core/geometry/pose2.h"
#include "core/io/log_notes.h"

namespace loopscope {

/// What must be known of a CARMEN log before its scans can be read.
struct CarmenSurvey {
  /// First word of the lines whose scans are taken: of one scanner, if possible the front one, and
  /// where it is told several times, in the form that tells most. Empty if the log has no scans.
  std::string scan_word;
  Pose2 base_from_laser;                                       ///< of this scanner, after PARAM
  double max_range = std::numeric_limits<double>::infinity();  ///< [m] after PARAM
};

/// Reads the whole log once. Tells which scans and parameters were taken, and which lines were not.
/// Throws FileError if the file cannot be read.
CarmenSurvey SurveyCarmenLog(const std::string& path, LogNotes* notes);

}  // namespace loopscope
