// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

// The lines of a CARMEN log one by one, after the message formats that CARMEN's logger writes at
// the head of its files. Every message ends in "ipc_time host logger_time".

/// What a line says about time [s]; 0 where it says nothing.
struct CarmenStamps {
  double ipc = 0.0;     ///< when the message was sent
  double logger = 0.0;  ///< when it was written, often counted from the start of the log
};

struct CarmenScan {
  BeamGeometry beams;
  bool beams_assumed = false;  ///< the line only tells how many there are
  double max_range = std::numeric_limits<double>::infinity();  ///< as announced in the line
  std::vector<float> readings;           ///< as written; NaN where no number is
  std::optional<Pose2> odom_from_laser;  ///< if the line has it
};

/// A line that was understood: odometry, a scan, or both.
struct CarmenRecord {
  int line = 0;
  CarmenStamps stamps;
  std::optional<Pose2> odom_from_base;
  std::optional<CarmenScan> scan;
};

/// Either the record, or why there is none, as the phrase of a LogNote.
using CarmenParse = std::variant<CarmenRecord, std::string>;

enum class ScanLayout {
  kOldStyle,    ///< FLASER, RLASER: readings, pose of laser, pose of robot
  kRawLaser,    ///< RAWLASERn: geometry, readings, remissions
  kRobotLaser,  ///< ROBOTLASERn: as RAWLASERn, with pose of laser, pose of robot
};

/// The layout of scans that lines beginning with `word` have; nothing for other words.
std::optional<ScanLayout> LayoutOf(std::string_view word);

/// `words` of an ODOM line. With `cut_off`, nothing may be missing at the end.
CarmenParse ParseCarmenOdometry(const std::vector<std::string_view>& words, bool cut_off);

/// `words` of a line that has a scan.
CarmenParse ParseCarmenScan(const std::vector<std::string_view>& words, bool cut_off);

/// The beams that old-style lines with so many readings have: those of the SICK LMS, LMS1xx and
/// Hokuyo scanners that have this number, half a turn from -90 degrees otherwise.
BeamGeometry AssumedBeams(int num_beams);

}  // namespace loopscope
