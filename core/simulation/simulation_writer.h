// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>

#include "core/simulation/simulate.h"

namespace loopscope {

/// Writes a CARMEN log: PARAM lines with what old-style scans do not tell, an ODOM line for each
/// odometry reading and after it the scan that it belongs to. Scans of 180, 181, 360 or 361 beams
/// over half a turn become FLASER lines, others ROBOTLASER1 with explicit geometry. A beam without
/// return is written as 81.91, an invalid one as 0. Poses and stamps have 6 decimals, ranges as
/// many as needed to give the same float again.
void WriteCarmenLog(const ScanLog& log, std::ostream& out);

/// Writes exact relations in the format of Kuemmerle et al. 2009, `t1 t2 x y z roll pitch yaw`, the
/// pose at t2 seen from t1, between stamps of the trajectory: from each keyframe (one a metre) to
/// the next one, and from each keyframe to the nearest earlier one at the same place, if the robot
/// had been away in between.
void WriteRelations(const Trajectory& map_from_base, std::ostream& out);

/// Writes `time x y 0 0 0 qz qw` lines, as the TUM tools read them.
void WriteTumTrajectory(const Trajectory& map_from_base, std::ostream& out);

/// Where the parts of a simulation went.
struct SimulationFiles {
  std::string log;           ///< gzip if it ends in .gz
  std::string relations;     ///< beside the log, .log or .log.gz replaced by .relations
  std::string ground_truth;  ///< likewise .tum
};

/// Writes the log to `log_path` and the rest beside it. Throws std::runtime_error that names the
/// file that cannot be written.
SimulationFiles SaveSimulation(const Simulation& simulation, const std::string& log_path);

}  // namespace loopscope
