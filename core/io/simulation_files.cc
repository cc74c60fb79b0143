// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/simulation_files.h"

#include "core/evaluation/true_relations.h"
#include "core/io/carmen_writer.h"
#include "core/io/log_stem.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"

namespace loopscope {

SimulationFiles WriteSimulation(const std::string& log_path, const Simulation& simulation) {
  const std::string stem = LogStem(log_path);
  const SimulationFiles files{log_path, stem + ".relations", stem + ".tum"};
  WriteCarmenLog(files.log, simulation.log);
  WriteRelations(files.relations, TrueRelations(simulation.ground_truth));
  WriteTum(files.ground_truth, simulation.ground_truth);
  return files;
}

}  // namespace loopscope
