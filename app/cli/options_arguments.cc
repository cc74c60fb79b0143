// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options_arguments.h"

#include <cstdio>

#include <CLI/CLI.hpp>

#include "core/io/options_file.h"
#include "core/slam/option_values.h"

namespace loopscope {

void AddOptionsArguments(CLI::App* command, OptionsArguments* arguments) {
  CLI::Option* const file =
      command
          ->add_option("--options", arguments->file,
                       "Options file: Cartographer's Lua as it is, or lines \"key = value\"")
          ->type_name("FILE");
  command
      ->add_option("--preset", arguments->preset,
                   "Options to begin with, without a file: loopscope (the default) maps every log "
                   "well, cartographer has Cartographer's stock values")
      ->type_name("NAME")
      ->check(CLI::IsMember({"loopscope", "cartographer"}))
      ->excludes(file);
  command
      ->add_option("--set", arguments->assignments,
                   "Set one option, e.g. --set POSE_GRAPH.constraint_builder.min_score=0.6; "
                   "may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--no-odometry", arguments->no_odometry,
                    "Map from the scans alone, even if the log has odometry");
}

Options ToOptions(const OptionsArguments& arguments) {
  Options options = arguments.preset == "cartographer" ? CartographerPreset() : LoopscopePreset();
  if (!arguments.file.empty()) {
    OptionsFile file = ReadOptionsFile(arguments.file);
    for (const std::string& note : file.notes) {
      std::fprintf(stderr, "%s: %s\n", arguments.file.c_str(), note.c_str());
    }
    options = file.options;
  }
  for (const std::string& assignment : arguments.assignments) {
    SetFromAssignment(assignment, &options);
  }
  if (arguments.no_odometry) options.trajectory_builder_2d.use_odometry = false;
  return options;
}

}  // namespace loopscope
