// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/picture_arguments.h"
#include "app/cli/run_arguments.h"
#include "core/io/words.h"
#include "render/picture_format.h"
#include "core/slam/derive.h"
#include "render/layers/search_part.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

struct RenderArguments {
  std::string run;
  std::string view = "map";
  std::string output;
  std::optional<int> step;
  std::optional<double> time;
  std::optional<int> node;
  std::optional<int> submap;
  std::optional<int> visits;
  std::optional<int> height;
  std::optional<double> angle;
  std::vector<std::string> layers;
  std::vector<double> center;
  std::optional<double> width_in_meters;
  PictureArguments picture;
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

/// Adds `text`, which is "grid" or, with an opacity, "grid:0.4".
void AddLayer(const std::string& text, ViewRequest* request) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const LayerKind kind = LayerKindFromName(text.substr(0, colon));
  request->layers->insert(kind);
  if (colon == text.size()) return;
  const auto opacity = ParseDouble(std::string_view(text).substr(colon + 1));
  if (!opacity || !(*opacity >= 0.0 && *opacity <= 1.0)) {
    throw std::invalid_argument(
        fmt::format("--layers {}: expected an opacity of 0 to 1 behind the colon", text));
  }
  request->opacities[kind] = *opacity;
}

/// Of the search that `request` asks for, the angle nearest to `degrees`.
int AngleIndexOf(const Recording& recording, const ViewRequest& request, double degrees) {
  if (request.view != ViewKind::kSearch) return 0;  // refused later
  const auto [submap, node] = SearchedPairOf(recording, request);
  const auto search = ReplaySearch(recording, submap, node);
  return search ? AngleIndexNear(search->trace.window, DegreesToRadians(degrees)) : 0;
}

ViewRequest ToRequest(const RenderArguments& arguments, const Recording& recording) {
  ViewRequest request;
  request.view = ViewKindFromName(arguments.view);
  request.step = arguments.time ? StepAtTime(recording, *arguments.time) : arguments.step;
  if (arguments.node) request.node = NodeOf(recording, *arguments.node);
  if (arguments.submap) request.submap = SubmapOf(recording, *arguments.submap);
  request.search = {arguments.visits, arguments.height, std::nullopt};
  if (arguments.angle) {
    request.search.angle_index = AngleIndexOf(recording, request, *arguments.angle);
  }
  if (!arguments.layers.empty()) {
    request.layers.emplace();
    for (const std::string& layer : arguments.layers) AddLayer(layer, &request);
  }
  if (!arguments.center.empty()) {
    request.center = Eigen::Vector2d(arguments.center[0], arguments.center[1]);
  }
  request.width_in_meters = arguments.width_in_meters;
  ApplyTo(arguments.picture, &request);
  return request;
}

int RunRender(const RenderArguments& arguments) {
  if (!arguments.output.empty()) PictureFormatOf(arguments.output);  // before the work begins
  const Recording recording = ReadRun(arguments.run);
  const ViewRequest request = ToRequest(arguments, recording);
  const std::string output =
      arguments.output.empty()
          ? std::filesystem::path(arguments.run).stem().string() + "." + arguments.view + ".png"
          : arguments.output;
  DrawPicture(recording, request, BackendFromName(arguments.picture.backend), output);
  fmt::print("{}\n", output);
  return 0;
}

void AddSelection(CLI::App* command, RenderArguments* arguments) {
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
  command
      ->add_option("--node", arguments->node,
                   "Node to show (update, match, search) or to mark (map, graph)")
      ->type_name("N");
  command
      ->add_option("--submap", arguments->submap,
                   "Submap to show (submap, update, search) or to mark (map, graph)")
      ->type_name("M");
}

void AddSearchFilter(CLI::App* command, RenderArguments* arguments) {
  command
      ->add_option("--visits", arguments->visits,
                   "Show the search as it was after so many visits of its tree (search)")
      ->type_name("K");
  command->add_option("--height", arguments->height, "Show the blocks of this height only (search)")
      ->type_name("H");
  command
      ->add_option("--angle", arguments->angle,
                   "Show the blocks of the angle nearest to this one only, from the guess (search)")
      ->type_name("DEGREES");
}

}  // namespace

void AddRenderCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("render", "Draw a picture of a recording, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  AddRunArgument(command, &arguments->run);
  command
      ->add_option("--view", arguments->view,
                   "What to draw:\n"
                   "  map     all submaps at their optimized poses, and the way (default)\n"
                   "  submap  one probability grid, its scans and its frame\n"
                   "  update  what one scan hit and missed, and the odds before and after\n"
                   "  match   one scan where it was predicted and where it was matched\n"
                   "  search  one loop search: where it looked, and what it pruned\n"
                   "  graph   nodes, submaps, constraints and residuals")
      ->type_name("VIEW");
  command
      ->add_option("-o,--output", arguments->output,
                   "PNG, SVG or PDF to write, by its name (default: RUN.VIEW.png, here)")
      ->type_name("FILE");
  AddSelection(command, arguments.get());
  AddSearchFilter(command, arguments.get());
  command
      ->add_option("--layers", arguments->layers,
                   "Draw only these layers of the view, each with an opacity behind a colon if it "
                   "is to be clearer, e.g. grid:0.4,nodes,inter")
      ->type_name("A,B,...")
      ->delimiter(',');
  command->add_option("--center", arguments->center, "Point in the middle [m], in the view's frame")
      ->type_name("X,Y")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--width", arguments->width_in_meters, "Width of what is shown [m]")
      ->type_name("METERS");
  AddPictureArguments(command, &arguments->picture);
  command->callback([arguments, exit_code] { *exit_code = RunRender(*arguments); });
}

}  // namespace loopscope
