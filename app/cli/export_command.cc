// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "core/io/graph_export.h"
#include "core/io/map_export.h"
#include "core/io/tum_file.h"
#include "core/slam/trajectories.h"

namespace loopscope {
namespace {

struct ExportArguments {
  std::string run;
  std::string map;
  bool raw = false;
  std::string trajectory;
  bool dense = false;
  std::string graph;
  std::optional<int> step;
};

int RunExport(const ExportArguments& arguments) {
  if (arguments.map.empty() && arguments.trajectory.empty() && arguments.graph.empty()) {
    throw std::invalid_argument("nothing to export; expected --map, --trajectory or --graph");
  }
  const Recording recording = ReadRun(arguments.run);
  const MapState state = StateOf(recording, arguments.step);
  if (!arguments.map.empty()) {
    const MapFiles files =
        ExportMap(BuildOccupancyMap(recording, state),
                  arguments.raw ? MapPixels::kGreys : MapPixels::kTrinary, arguments.map);
    fmt::print("{}\n{}\n", files.image, files.yaml);
  }
  if (!arguments.trajectory.empty()) {
    WriteTum(arguments.trajectory, arguments.dense ? DenseTrajectory(recording, state)
                                                   : NodeTrajectory(recording, state));
    fmt::print("{}\n", arguments.trajectory);
  }
  if (!arguments.graph.empty()) {
    ExportGraph(recording, state, arguments.graph);
    fmt::print("{}\n", arguments.graph);
  }
  return 0;
}

}  // namespace

void AddExportCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "export", "Write map, trajectory and pose graph in formats that other programs read");
  const auto arguments = std::make_shared<ExportArguments>();
  AddRunArgument(command, &arguments->run);
  CLI::Option* const map =
      command
          ->add_option("--map", arguments->map,
                       "Occupancy grid as ROS' map_server reads it: M.pgm and M.yaml")
          ->type_name("M");
  command
      ->add_flag("--raw", arguments->raw,
                 "Keep intermediate greys in the map instead of free, occupied and unknown")
      ->needs(map);
  CLI::Option* const trajectory =
      command
          ->add_option("--trajectory", arguments->trajectory,
                       "Optimized poses of the nodes, lines \"time x y z qx qy qz qw\" as the TUM "
                       "tools read them")
          ->type_name("T.tum");
  command
      ->add_flag("--dense", arguments->dense,
                 "A pose for every stamp of scans and odometry in the trajectory, instead of nodes")
      ->needs(trajectory);
  command
      ->add_option("--graph", arguments->graph,
                   "Pose graph for g2o: VERTEX_SE2 and EDGE_SE2 with information matrices")
      ->type_name("G.g2o");
  command
      ->add_option("--step", arguments->step,
                   "The state as it was after this scan, counted from 0 (default: the last one)")
      ->type_name("N");
  command->callback([arguments, exit_code] { *exit_code = RunExport(*arguments); });
}

}  // namespace loopscope
