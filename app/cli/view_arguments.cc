// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/view_arguments.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/run_arguments.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

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

/// "12:3": a node and a submap.
LoopPair PairOf(const Recording& recording, const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto node = ParseInt(std::string_view(text).substr(0, colon));
  const auto submap = ParseInt(std::string_view(text).substr(std::min(colon + 1, text.size())));
  if (!node || !submap) {
    throw std::invalid_argument("--mark " + text + ": expected a node and a submap, as in 120:3");
  }
  return {NodeOf(recording, *node), SubmapOf(recording, *submap)};
}

void AddSearchFilter(CLI::App* command, SearchFilter* filter) {
  command
      ->add_option("--visits", filter->num_visits,
                   "Show the search as it was after so many visits of its tree (search)")
      ->type_name("K");
  command->add_option("--height", filter->height, "Show the blocks of this height only (search)")
      ->type_name("H");
  command
      ->add_option("--angle", filter->angle_index,
                   "Show the blocks of this angle only: 0 is that of the estimate, 1 the next one "
                   "to the left (search)")
      ->type_name("I");
}

}  // namespace

void AddViewArguments(CLI::App* command, ViewArguments* arguments) {
  command
      ->add_option("--view", arguments->view,
                   "What to draw:\n"
                   "  map     all submaps at their optimized poses, and the way (default)\n"
                   "  submap  one probability grid, its scans and its frame\n"
                   "  update  what one scan hit and missed, and the odds before and after\n"
                   "  match   one scan where it was predicted and where it was matched\n"
                   "  search  one loop search: where it looked, and what it pruned\n"
                   "  graph   nodes, submaps, constraints and residuals\n"
                   "  time    the graph from the side, with time upwards over the map\n"
                   "  chart   numbers of the run, see --chart")
      ->type_name("VIEW");
  command
      ->add_option("--node", arguments->node,
                   "Node to show (update, match, search) or to mark (map, graph, time)")
      ->type_name("N");
  command
      ->add_option("--submap", arguments->submap,
                   "Submap to show (submap, update, search) or to mark (map, graph, time)")
      ->type_name("M");
  command
      ->add_option("--mark", arguments->marked,
                   "Loops to mark beside it, each a node and a submap (map, graph, time, chart)")
      ->type_name("N:M,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  AddSearchFilter(command, &arguments->search);
  command
      ->add_option("--layers", arguments->layers,
                   "Draw only these layers of the view, each with an opacity behind a colon if it "
                   "is to be clearer, e.g. grid:0.4,nodes,inter")
      ->type_name("A,B,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--center", arguments->center, "Point in the middle [m], in the view's frame")
      ->type_name("X,Y")
      ->delimiter(',')
      ->expected(2)
      ->allow_extra_args(false);
  command->add_option("--width", arguments->width_in_meters, "Width of what is shown [m]")
      ->type_name("METERS");
  command
      ->add_option("--min-height", arguments->height_in_meters,
                   "Least height of what is shown [m]; --width is then the least width")
      ->type_name("METERS");
  command
      ->add_option("--chart", arguments->chart,
                   "What the view chart shows: scores, score-histogram, residuals, "
                   "residual-histogram or costs (default: scores)")
      ->type_name("NAME");
  command
      ->add_option("--azimuth", arguments->azimuth,
                   "From which side to look at the view time [deg]: 0 is from -y, 90 from +x "
                   "(default: -30)")
      ->type_name("DEGREES");
  command
      ->add_option("--elevation", arguments->elevation,
                   "From how high, likewise: 0 is from the side, 90 from above (default: 30)")
      ->type_name("DEGREES");
  AddPictureArguments(command, &arguments->picture);
}

ViewRequest ToRequest(const ViewArguments& arguments, const Recording& recording) {
  ViewRequest request;
  request.view = ViewKindFromName(arguments.view);
  if (arguments.node) request.node = NodeOf(recording, *arguments.node);
  if (arguments.submap) request.submap = SubmapOf(recording, *arguments.submap);
  for (const std::string& pair : arguments.marked) {
    request.marked.push_back(PairOf(recording, pair));
  }
  request.search = arguments.search;
  if (!arguments.layers.empty()) {
    request.layers.emplace();
    for (const std::string& layer : arguments.layers) AddLayer(layer, &request);
  }
  if (!arguments.center.empty()) {
    request.center = Eigen::Vector2d(arguments.center[0], arguments.center[1]);
  }
  request.width_in_meters = arguments.width_in_meters;
  request.height_in_meters = arguments.height_in_meters;
  if (arguments.chart) {
    if (request.view != ViewKind::kChart) {
      throw std::invalid_argument("--chart " + *arguments.chart + ": expected --view chart");
    }
    request.chart = ChartKindFromName(*arguments.chart);
  }
  request.azimuth = arguments.azimuth;
  request.elevation = arguments.elevation;
  ApplyTo(arguments.picture, &request);
  return request;
}

}  // namespace loopscope
