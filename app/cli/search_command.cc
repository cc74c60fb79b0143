// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/picture_arguments.h"
#include "app/cli/run_arguments.h"
#include "core/matching/search_lattice.h"
#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"
#include "render/picture_format.h"

namespace loopscope {
namespace {

struct SearchArguments {
  std::string run;
  int node = 0;
  int submap = 0;
  std::optional<double> min_score;
  bool whole_submap = false;
  std::string output;
  bool json = false;
  PictureArguments picture;
};

/// What became of the search nodes of one height.
struct HeightCounts {
  int scored = 0;
  int expanded = 0;
  int pruned = 0;
  int improved = 0;
};

std::map<int, HeightCounts, std::greater<>> CountsByHeight(const SearchTrace& trace) {
  std::map<int, HeightCounts, std::greater<>> counts;
  for (const SearchNode& node : trace.nodes) {
    HeightCounts& at_height = counts[node.height];
    ++at_height.scored;
    at_height.expanded += node.fate == SearchFate::kExpanded;
    at_height.pruned += node.fate == SearchFate::kPruned;
    at_height.improved += node.fate == SearchFate::kImproved;
  }
  return counts;
}

/// From a start node down to the winner; empty if there is none.
std::vector<SearchNode> WayToWinner(const SearchTrace& trace) {
  std::vector<SearchNode> way;
  for (int i = trace.winner; i >= 0; i = trace.nodes[i].parent) way.push_back(trace.nodes[i]);
  std::reverse(way.begin(), way.end());
  return way;
}

std::string ToText(const Pose2& pose) {
  return fmt::format("{:.3f} m, {:.3f} m, {:.2f} deg", pose.x(), pose.y(),
                     RadiansToDegrees(pose.rotation));
}

void PrintTree(const SearchTrace& trace) {
  fmt::print("\n{:>6} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "height", "block [m]", "scored", "expanded",
             "pruned", "improved");
  for (const auto& [height, counts] : CountsByHeight(trace)) {
    fmt::print("{:>6} {:>9.2f} {:>9} {:>9} {:>9} {:>9}\n", height,
               trace.window.resolution * (1 << height), counts.scored, counts.expanded,
               counts.pruned, counts.improved);
  }
  if (trace.winner < 0) return;
  fmt::print("\nway to the winner:\n");
  for (const SearchNode& node : WayToWinner(trace)) {
    fmt::print("  height {}: x {:+.2f} m, y {:+.2f} m, {:+.2f} deg, bound {:.4f}\n", node.height,
               trace.window.resolution * node.offset.x, trace.window.resolution * node.offset.y,
               RadiansToDegrees(trace.window.angular_step * node.angle_index), node.bound);
  }
}

void PrintFound(const LoopCandidate& result) {
  fmt::print("score     {:.4f}{}, needed {:.4f}; no pose that is tried has more than {:.4f}\n",
             result.score, IsFound(result.verdict) ? "" : ", the best seen", result.min_score,
             result.score_bound);
  fmt::print("{:<10}{}\n", IsFound(result.verdict) ? "found at" : "seen at",
             ToText(result.submap_from_node_searched));
}

void PrintSearch(const SearchReplay& search) {
  const SearchWindow& window = search.trace.window;
  const LoopCandidate& result = search.result;
  const double num_poses = NumPoses(window);
  const double num_scored = static_cast<double>(search.trace.nodes.size());
  fmt::print("node {}, submap {}: {}\n", ToString(result.node), ToString(result.submap),
             search.recorded ? "as the mapper searched it" : "the mapper did not search it");
  fmt::print("guess     {}\n", ToText(search.candidate.submap_from_node_guess));
  fmt::print("window    +-{:.2f} m in steps of {:g} m, +-{:.1f} deg in steps of {:.3f} deg\n",
             result.linear_search_window, window.resolution,
             RadiansToDegrees(result.angular_search_window), RadiansToDegrees(window.angular_step));
  fmt::print("poses     {:.0f}, of which {:.0f} nodes of the tree were scored ({:.2g} %)\n",
             num_poses, num_scored, 100.0 * num_scored / num_poses);
  PrintFound(result);
  if (IsFound(result.verdict)) fmt::print("refined   {}\n", ToText(result.submap_from_node));
  if (search.recorded) fmt::print("verdict   {}\n", ToString(search.candidate.verdict));
  PrintTree(search.trace);
}

nlohmann::ordered_json ToJson(const Pose2& pose) {
  return {{"x", pose.x()}, {"y", pose.y()}, {"rotation", pose.rotation}};
}

/// Null if nothing was found to refine.
nlohmann::ordered_json RefinedToJson(const LoopCandidate& result) {
  if (!IsFound(result.verdict)) return nullptr;
  return ToJson(result.submap_from_node);
}

void PrintJson(const SearchReplay& search) {
  static const char* const kFates[] = {"expanded", "pruned", "improved"};
  const SearchWindow& window = search.trace.window;
  nlohmann::ordered_json nodes = nlohmann::ordered_json::array();
  for (const SearchNode& node : search.trace.nodes) {
    nodes.push_back({{"parent", node.parent},
                     {"height", node.height},
                     {"x", node.offset.x},
                     {"y", node.offset.y},
                     {"angle", node.angle_index},
                     {"bound", node.bound},
                     {"fate", kFates[static_cast<int>(node.fate)]}});
  }
  const LoopCandidate& result = search.result;
  std::cout << nlohmann::ordered_json({{"node", result.node.index},
                                       {"submap", result.submap.index},
                                       {"recorded", search.recorded},
                                       {"guess", ToJson(search.candidate.submap_from_node_guess)},
                                       {"linear_steps", window.num_linear_steps},
                                       {"angular_steps", window.num_angular_steps},
                                       {"resolution", window.resolution},
                                       {"angular_step", window.angular_step},
                                       {"score", result.score},
                                       {"min_score", result.min_score},
                                       {"score_bound", result.score_bound},
                                       {"searched", ToJson(result.submap_from_node_searched)},
                                       {"found", IsFound(result.verdict)},
                                       {"refined", RefinedToJson(result)},
                                       {"winner", search.trace.winner},
                                       {"nodes", std::move(nodes)}})
                   .dump(1)
            << "\n";
}

/// Of a search everywhere in the submap.
void PrintWhole(const LoopCandidate& found) {
  fmt::print("node {}, submap {}: everywhere in the submap, at every angle\n", ToString(found.node),
             ToString(found.submap));
  fmt::print("guess     {}\n", ToText(found.submap_from_node_guess));
  PrintFound(found);
  if (!IsFound(found.verdict)) return;
  const Pose2 guess_from_node = found.submap_from_node_guess.Inverse() * found.submap_from_node;
  fmt::print("refined   {}\n", ToText(found.submap_from_node));
  fmt::print("off by    {:.3f} m, {:.2f} deg from the guess\n", guess_from_node.translation.norm(),
             RadiansToDegrees(std::abs(guess_from_node.rotation)));
}

void PrintWholeJson(const LoopCandidate& found) {
  std::cout << nlohmann::ordered_json({{"node", found.node.index},
                                       {"submap", found.submap.index},
                                       {"guess", ToJson(found.submap_from_node_guess)},
                                       {"score", found.score},
                                       {"min_score", found.min_score},
                                       {"score_bound", found.score_bound},
                                       {"searched", ToJson(found.submap_from_node_searched)},
                                       {"found", IsFound(found.verdict)},
                                       {"refined", RefinedToJson(found)}})
                   .dump(1)
            << "\n";
}

void DrawSearch(const Recording& recording, const SearchArguments& arguments) {
  ViewRequest request;
  request.view = ViewKind::kSearch;
  request.node = NodeId{arguments.node};
  request.submap = SubmapId{arguments.submap};
  ApplyTo(arguments.picture, &request);
  DrawPicture(recording, request, BackendFromName(arguments.picture.backend), arguments.output);
}

[[noreturn]] void RefusePair(SubmapId submap, NodeId node) {
  throw std::invalid_argument(fmt::format(
      "node {} cannot be searched in submap {}; expected a finished submap that it is no part of",
      ToString(node), ToString(submap)));
}

/// The exit code.
int SearchWhole(const Recording& recording, SubmapId submap, NodeId node,
                const SearchArguments& arguments) {
  const auto found = SearchWholeSubmap(recording, submap, node, arguments.min_score);
  if (!found) RefusePair(submap, node);
  if (arguments.json) {
    PrintWholeJson(*found);
  } else {
    PrintWhole(*found);
  }
  return IsFound(found->verdict) ? 0 : 1;
}

int RunSearch(const SearchArguments& arguments) {
  if (!arguments.output.empty()) PictureFormatOf(arguments.output);  // before the work begins
  const Recording recording = ReadRun(arguments.run);
  const NodeId node = NodeOf(recording, arguments.node);
  const SubmapId submap = SubmapOf(recording, arguments.submap);
  if (arguments.whole_submap) return SearchWhole(recording, submap, node, arguments);
  const auto search = ReplaySearch(recording, submap, node, arguments.min_score);
  if (!search) RefusePair(submap, node);
  if (arguments.json) {
    PrintJson(*search);
  } else {
    PrintSearch(*search);
  }
  if (!arguments.output.empty()) DrawSearch(recording, arguments);
  return IsFound(search->result.verdict) ? 0 : 1;
}

}  // namespace

void AddSearchCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "search", "Replay one loop search: numbers, tree and picture (exit code 1: nothing found)");
  const auto arguments = std::make_shared<SearchArguments>();
  AddRunArgument(command, &arguments->run);
  command->add_option("--node", arguments->node, "Index of the node")->required()->type_name("N");
  command->add_option("--submap", arguments->submap, "Index of the submap")
      ->required()
      ->type_name("M");
  command
      ->add_option("--min-score", arguments->min_score,
                   "Search for poses of this score, instead of that of the options")
      ->check(RefuseNan)
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("S");
  CLI::Option* const output =
      command
          ->add_option("-o,--output", arguments->output, "Draw the search too, as PNG, SVG or PDF")
          ->type_name("FILE");
  command
      ->add_flag("--whole-submap", arguments->whole_submap,
                 "Search everywhere in the submap, at every angle, as the mapper never does; tells "
                 "what a window missed, without a tree")
      ->excludes(output);
  command->add_flag("--json", arguments->json, "Print JSON, with every node of the tree");
  AddPictureArguments(command, &arguments->picture);
  command->callback([arguments, exit_code] { *exit_code = RunSearch(*arguments); });
}

}  // namespace loopscope
