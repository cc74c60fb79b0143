// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <stdexcept>

#include "app/session/command_groups.h"

namespace loopscope {
namespace {

ViewKind ActiveView(const SessionState& state) { return state.tiles[state.active_tile]; }

/// `count` views: those that are shown, then others that go with them.
std::vector<ViewKind> TilesOf(const SessionState& state, std::size_t count) {
  std::vector<ViewKind> tiles{ActiveView(state)};
  std::vector<ViewKind> others = state.tiles;
  others.insert(others.end(), {ViewKind::kMap, ViewKind::kSearch, ViewKind::kGraph,
                               ViewKind::kMatch, ViewKind::kUpdate});
  for (const ViewKind kind : others) {
    const bool is_new = std::find(tiles.begin(), tiles.end(), kind) == tiles.end();
    if (tiles.size() < count && is_new) tiles.push_back(kind);
  }
  return tiles;
}

Command ViewCommand(ViewKind kind, const char* title, const char* key) {
  return StateCommand({"view." + ToString(kind), title, "View", {key}, "", Always, {}},
                      [kind](const Session&, const std::string&, SessionState* state) {
                        state->tiles[state->active_tile] = kind;
                      });
}

Command TilesCommand(const char* name, const char* title, const char* key, std::size_t count) {
  return StateCommand({name, title, "View", {key}, "", Always, {}},
                      [count](const Session&, const std::string&, SessionState* state) {
                        state->tiles = TilesOf(*state, count);
                        state->active_tile = 0;
                      });
}

void SelectTile(const std::string& argument, SessionState* state) {
  const int tile = IntArgument("tile.select", argument);
  const int count = static_cast<int>(state->tiles.size());
  if (tile < 0 || tile >= count) {
    throw std::invalid_argument("tile.select " + argument + ": expected 0 to " +
                                std::to_string(count - 1));
  }
  state->active_tile = tile;
}

LayerKind LayerOf(ViewKind view, const std::string& name) {
  const LayerKind layer = LayerKindFromName(name);
  if (LayersOf(view).count(layer) > 0) return layer;
  throw std::invalid_argument("view " + ToString(view) + " has no layer '" + name + "'");
}

void ToggleLayer(const std::string& argument, SessionState* state) {
  const ViewKind view = ActiveView(*state);
  const LayerKind layer = LayerOf(view, argument);
  auto& layers = state->views[view].layers;
  if (!layers) layers = DefaultLayersOf(view);
  if (layers->erase(layer) == 0) layers->insert(layer);
  if (*layers == DefaultLayersOf(view)) layers.reset();
}

/// "grid 0.4"
void SetOpacity(const std::string& argument, SessionState* state) {
  const std::size_t space = std::min(argument.find(' '), argument.size());
  const ViewKind view = ActiveView(*state);
  const LayerKind layer = LayerOf(view, argument.substr(0, space));
  const double opacity =
      NumberArgument("layer.opacity", argument.substr(std::min(space + 1, argument.size())));
  if (!(opacity >= 0.0 && opacity <= 1.0)) {
    throw std::invalid_argument("layer.opacity " + argument + ": expected 0 to 1");
  }
  state->views[view].opacities[layer] = opacity;
  if (opacity == 1.0) state->views[view].opacities.erase(layer);
}

void SetCamera(const std::string& argument, SessionState* state) {
  if (ActiveView(*state) == ViewKind::kChart) {
    throw std::invalid_argument("camera.set " + argument + ": view chart has no map");
  }
  const std::vector<double> numbers = NumbersArgument("camera.set", argument, 3);
  if (!(numbers[2] > 0.0)) {
    throw std::invalid_argument("camera.set " + argument + ": expected a width above 0 m");
  }
  state->views[ActiveView(*state)].camera = ViewCamera{{numbers[0], numbers[1]}, numbers[2]};
}

std::vector<Command> LayerAndCameraCommands() {
  return {
      StateCommand({"layer.toggle", "Show or hide a layer", "", {}, "NAME", Always, {}},
                   [](const Session&, const std::string& argument, SessionState* state) {
                     ToggleLayer(argument, state);
                   }),
      StateCommand({"layer.opacity", "How much a layer covers", "", {}, "NAME SHARE", Always, {}},
                   [](const Session&, const std::string& argument, SessionState* state) {
                     SetOpacity(argument, state);
                   }),
      StateCommand({"layer.reset", "Layers as they were", "View", {}, "", Always, {}},
                   [](const Session&, const std::string&, SessionState* state) {
                     state->views[ActiveView(*state)].layers.reset();
                     state->views[ActiveView(*state)].opacities.clear();
                   }),
      StateCommand({"camera.set", "Look at", "", {}, "X Y WIDTH", Always, {}},
                   [](const Session&, const std::string& argument, SessionState* state) {
                     SetCamera(argument, state);
                   }),
      StateCommand({"camera.fit", "Show all", "View", {"Shift+F", "Backspace"}, "", Always, {}},
                   [](const Session&, const std::string&, SessionState* state) {
                     state->views[ActiveView(*state)].camera.reset();
                   }),
      StateCommand(
          {"theme.color_blind", "Colours for any colour vision", "Window", {}, "", Always, {}},
          [](const Session&, const std::string&, SessionState* state) {
            state->theme = Theme::kColorBlind;
          }),
      StateCommand({"theme.default", "Cartographer's colours", "Window", {}, "", Always, {}},
                   [](const Session&, const std::string&, SessionState* state) {
                     state->theme = Theme::kDefault;
                   }),
  };
}

}  // namespace

std::vector<Command> ViewCommands() {
  std::vector<Command> commands{
      ViewCommand(ViewKind::kMap, "Map", "1"),
      ViewCommand(ViewKind::kSubmap, "Submap", "2"),
      ViewCommand(ViewKind::kUpdate, "Update", "3"),
      ViewCommand(ViewKind::kMatch, "Match", "4"),
      ViewCommand(ViewKind::kSearch, "Search", "5"),
      ViewCommand(ViewKind::kGraph, "Pose graph", "6"),
      ViewCommand(ViewKind::kTime, "Pose graph over time", "7"),
      ViewCommand(ViewKind::kChart, "Chart", "8"),
      StateCommand({"chart.kind", "What the chart shows", "", {}, "NAME", Always, {}},
                   [](const Session&, const std::string& argument, SessionState* state) {
                     state->chart = ChartKindFromName(argument);
                   }),
      TilesCommand("tiles.one", "One view", "Ctrl+1", 1),
      TilesCommand("tiles.two", "Two views", "Ctrl+2", 2),
      TilesCommand("tiles.four", "Four views", "Ctrl+4", 4),
      StateCommand({"tile.select", "Go to view", "", {}, "N", Always, {}},
                   [](const Session&, const std::string& argument, SessionState* state) {
                     SelectTile(argument, state);
                   }),
      StateCommand({"tile.next", "Next view", "View", {"Ctrl+Tab"}, "", Always, {}},
                   [](const Session&, const std::string&, SessionState* state) {
                     state->active_tile =
                         (state->active_tile + 1) % static_cast<int>(state->tiles.size());
                   }),
  };
  for (Command& command : LayerAndCameraCommands()) commands.push_back(std::move(command));
  return commands;
}

}  // namespace loopscope
