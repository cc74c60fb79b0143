// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/render_command_line.h"

#include <fmt/format.h>

namespace loopscope {
namespace {

std::string Quoted(const std::string& word) {
  const char* const plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The layers that are drawn, with their opacities.
std::string LayersText(const ViewRequest& request) {
  std::string text;
  for (const LayerKind layer : request.layers.value_or(DefaultLayersOf(request.view))) {
    text += (text.empty() ? "" : ",") + ToString(layer);
    const auto opacity = request.opacities.find(layer);
    if (opacity != request.opacities.end()) text += fmt::format(":{}", opacity->second);
  }
  return text;
}

}  // namespace

std::vector<std::string> RenderArguments(const ViewRequest& request, const std::string& run,
                                         const std::string& output) {
  std::vector<std::string> arguments{"render", run, "--view", ToString(request.view)};
  const auto add = [&](const char* name, const std::string& value) {
    arguments.insert(arguments.end(), {name, value});
  };
  if (request.step) add("--step", std::to_string(*request.step));
  if (request.node) add("--node", std::to_string(request.node->index));
  if (request.submap) add("--submap", std::to_string(request.submap->index));
  if (request.layers || !request.opacities.empty()) add("--layers", LayersText(request));
  if (request.center) {
    add("--center", fmt::format("{},{}", request.center->x(), request.center->y()));
  }
  if (request.width_in_meters) add("--width", fmt::format("{}", *request.width_in_meters));
  add("--size", fmt::format("{}x{}", request.width, request.height));
  if (request.text_height) add("--text", std::to_string(*request.text_height));
  if (request.theme == Theme::kColorBlind) add("--theme", "color-blind");
  if (!request.title.empty()) add("--title", request.title);
  add("-o", output);
  return arguments;
}

std::string RenderCommandLine(const ViewRequest& request, const std::string& run,
                              const std::string& output) {
  std::string line = "loopscope";
  for (const std::string& argument : RenderArguments(request, run, output)) {
    line += " " + Quoted(argument);
  }
  return line;
}

}  // namespace loopscope
