// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose2.h"

namespace loopscope {

/// Directions of the beams of a planar scanner in its own frame.
struct BeamGeometry {
  int num_beams = 0;
  double first_angle = 0.0;      ///< [rad], counter-clockwise from the scanner's x axis
  double angle_increment = 0.0;  ///< [rad] from one beam to the next

  double Angle(int beam) const { return first_angle + beam * angle_increment; }
};

bool operator==(const BeamGeometry& a, const BeamGeometry& b);

/// One revolution of the scanner.
struct LaserScan {
  double time = 0.0;      ///< [s], as the log has it: it may run backwards
  int beam_geometry = 0;  ///< index into ScanLog::beam_geometries
  /// Distances [m], one a beam (REP-117): +infinity where nothing came back, NaN where the reading
  /// is invalid.
  std::vector<float> ranges;
  /// Number of entries of ScanLog::odometry that stand before this scan in the log.
  int num_odometry_before = 0;
};

struct OdometryReading {
  double time = 0.0;  ///< [s], as the log has it: it may run backwards
  Pose2 odom_from_base;
};

/// Something in a log that a reader corrected, dropped or wants the user to know.
struct LogNote {
  std::string what;    ///< one phrase, e.g. "stamps that run backwards"
  int count = 0;       ///< how often
  int first_line = 0;  ///< where it was seen first, counted from 1
};

/// A whole log. The order of the vectors is the order of the file, which is taken as the true order
/// of events, whatever the stamps say.
struct ScanLog {
  std::string name;  ///< name of the file without folder
  std::vector<BeamGeometry> beam_geometries;
  Pose2 base_from_laser;  ///< where the scanner is mounted on the robot
  std::vector<LaserScan> scans;
  std::vector<OdometryReading> odometry;  ///< raw, empty if the log has none
  std::vector<LogNote> notes;
};

/// The last odometry reading that stands before scan `scan` in the log, if there is one.
std::optional<OdometryReading> OdometryOfScan(const ScanLog& log, int scan);

}  // namespace loopscope
