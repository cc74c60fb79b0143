// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "core/io/simulation_files.h"
#include "core/simulation/simulate.h"

namespace loopscope {
namespace {

struct SimulateArguments {
  std::string output;
  std::string world = "office";
  SimulationOptions options;
};

std::string DescribeWorlds() {
  std::string text = "Where to drive:";
  for (const std::string& name : WorldNames()) {
    text += fmt::format("\n  {:<10} {}", name, MakeWorld(name).description);
  }
  return text;
}

int RunSimulate(const SimulateArguments& arguments) {
  const Simulation simulation = Simulate(MakeWorld(arguments.world), arguments.options);
  const SimulationFiles files = WriteSimulation(arguments.output, simulation);
  fmt::print("{}: {} scans, {} odometry readings\n{}: true relative poses\n{}: true trajectory\n",
             files.log, simulation.log.scans.size(), simulation.log.odometry.size(),
             files.relations, files.ground_truth);
  return 0;
}

}  // namespace

void AddSimulateCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "simulate", "Drive a robot through a built-in world, and write its log with the truth");
  const auto arguments = std::make_shared<SimulateArguments>();
  SimulationOptions* const options = &arguments->options;
  command
      ->add_option("-o,--output", arguments->output,
                   "CARMEN log to write, gzip if it ends in .gz; .relations and .tum go beside it")
      ->required()
      ->type_name("F.log");
  command->add_option("--world", arguments->world, DescribeWorlds())
      ->type_name("NAME")
      ->check(CLI::IsMember(WorldNames()))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of all noise: the same seed gives the same log")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--scan-period", options->scan_period, "Time from scan to scan [s]")
      ->type_name("S")
      ->capture_default_str();
  command->add_option("--max-range", options->lidar.max_range, "Reach of the scanner [m]")
      ->type_name("M")
      ->capture_default_str();
  command
      ->add_option("--range-noise", options->lidar.range_noise,
                   "Standard deviation of its readings [m]")
      ->type_name("M")
      ->capture_default_str();
  command
      ->add_option("--dropouts", options->lidar.dropout_probability,
                   "Share of its beams that are lost, 0 to 1")
      ->type_name("P")
      ->capture_default_str();
  command
      ->add_option("--odometry-scale", options->wheel_odometry.distance_scale,
                   "Measured over true distance")
      ->type_name("F")
      ->capture_default_str();
  command->callback([arguments, exit_code] { *exit_code = RunSimulate(*arguments); });
}

}  // namespace loopscope
