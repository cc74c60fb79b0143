// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/simulation/simulate.h"

namespace loopscope {

/// Where the parts of a simulation went.
struct SimulationFiles {
  std::string log;           ///< CARMEN, gzip if it ends in .gz
  std::string relations;     ///< beside it, .log or .log.gz replaced by .relations
  std::string ground_truth;  ///< likewise .tum: the pose at every stamp of the log
};

/// Writes the log to `log_path` and the truth beside it. Throws FileError.
SimulationFiles WriteSimulation(const std::string& log_path, const Simulation& simulation);

}  // namespace loopscope
