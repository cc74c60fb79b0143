// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "app/cli/view_arguments.h"
#include "render/picture_format.h"

namespace loopscope {
namespace {

struct RenderArguments {
  std::string run;
  std::string output;
  std::optional<int> step;
  std::optional<double> time;
  ViewArguments view;
};

/// The last scan that was mapped until `time`: a stamp of the log, or seconds since its first scan.
int StepAtTime(const Recording& recording, double time) {
  const auto& scans = recording.log().scans;
  const double first = scans.front().time;
  const double stamp = time < first ? first + time : time;
  int found = -1;
  double last = -std::numeric_limits<double>::infinity();
  for (int step = 0; step < recording.num_steps(); ++step) {
    last = std::max(last, scans[step].time);
    if (scans[step].time <= stamp) found = step;
  }
  if (found < 0 || stamp > last) {
    throw std::invalid_argument(
        fmt::format("no scan at --time {}; expected 0 to {:.3f}, or {:.6f} "
                    "to {:.6f}",
                    time, last - first, first, last));
  }
  return found;
}

int RunRender(const RenderArguments& arguments) {
  if (!arguments.output.empty()) PictureFormatOf(arguments.output);  // before the work begins
  const Recording recording = ReadRun(arguments.run);
  ViewRequest request = ToRequest(arguments.view, recording);
  request.step = arguments.time ? StepAtTime(recording, *arguments.time) : arguments.step;
  const std::string name = std::filesystem::path(arguments.run).stem().string();
  const std::string output =
      arguments.output.empty() ? name + "." + arguments.view.view + ".png" : arguments.output;
  DrawPicture(recording, request, BackendFromName(arguments.view.picture.backend), output);
  fmt::print("{}\n", output);
  return 0;
}

void AddStep(CLI::App* command, RenderArguments* arguments) {
  CLI::Option* const step =
      command
          ->add_option("--step", arguments->step,
                       "Show the state as it was after this scan, counted from 0 (default: the "
                       "last one, or that of --node)")
          ->type_name("N");
  command
      ->add_option("--time", arguments->time,
                   "Likewise by time: seconds since the first scan, or a stamp of the log")
      ->type_name("T")
      ->excludes(step);
}

}  // namespace

void AddRenderCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("render", "Draw a picture of a recording, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  AddRunArgument(command, &arguments->run);
  command
      ->add_option("-o,--output", arguments->output,
                   "PNG, SVG or PDF to write, by its name (default: RUN.VIEW.png, here)")
      ->type_name("FILE");
  AddStep(command, arguments.get());
  AddViewArguments(command, &arguments->view);
  command->callback([arguments, exit_code] { *exit_code = RunRender(*arguments); });
}

}  // namespace loopscope
