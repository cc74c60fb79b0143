// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>

#include "app/session/command_groups.h"
#include "core/io/words.h"
#include "core/slam/state.h"

namespace loopscope {
namespace {

/// `index`, which must be one of `count` things.
int Existing(const std::string& what, int index, std::size_t count) {
  if (index >= 0 && index < static_cast<int>(count)) return index;
  throw std::invalid_argument("there is no " + what + " " + std::to_string(index) +
                              ": expected 0 to " + std::to_string(static_cast<int>(count) - 1));
}

NodeId NodeArgument(const Session& session, double index) {
  return NodeId{Existing("node", static_cast<int>(index), session.recording().nodes().size())};
}

SubmapId SubmapArgument(const Session& session, double index) {
  return SubmapId{
      Existing("submap", static_cast<int>(index), session.recording().submaps().size())};
}

int LoopArgument(const Session& session, const std::string& name, const std::string& argument) {
  return Existing("loop", IntArgument(name, argument), session.recording().candidates().size());
}

/// Selects the pair of the first loop, and marks the others beside it.
void SelectLoops(const Session& session, const std::string& argument, SessionState* state) {
  std::vector<std::string_view> words;
  SplitWords(argument, &words);
  std::vector<int> loops;
  for (const std::string_view word : words) {
    loops.push_back(LoopArgument(session, "select.loops", std::string(word)));
  }
  if (loops.empty()) throw std::invalid_argument("select.loops: expected one loop at least");
  const LoopCandidate& first = session.recording().candidates()[loops.front()];
  state->node = first.node;
  state->submap = first.submap;
  state->loops.assign(loops.begin() + 1, loops.end());
}

/// Shows what is selected with some metres around it in the views of the whole map; all of the map
/// if nothing is selected.
void FrameSelection(const Session& session, SessionState* state) {
  constexpr double kAround = 1.6;
  constexpr double kMin = 6.0;  // [m]
  const MapState map = StateAfterStep(session.recording(), state->step);
  Eigen::AlignedBox2d box;
  if (state->node && state->node->index < map.num_nodes) {
    box.extend(map.global_from_node[state->node->index].translation);
  }
  if (state->submap && state->submap->index < map.num_submaps) {
    box.extend(map.global_from_submap[state->submap->index].translation);
  }
  for (const ViewKind view : {ViewKind::kMap, ViewKind::kGraph}) {
    auto& camera = state->views[view].camera;
    camera.reset();
    if (box.isEmpty()) continue;
    camera = ViewCamera{box.center(), std::max(kMin, kAround * box.sizes().x()),
                        std::max(kMin, kAround * box.sizes().y())};
  }
}

void GoToNode(const Session& session, const std::string& argument, SessionState* state) {
  state->node = NodeArgument(session, IntArgument("go.node", argument));
  state->submap.reset();
  state->step = session.recording().node(*state->node).step;
  FrameSelection(session, state);
}

void GoToSubmap(const Session& session, const std::string& argument, SessionState* state) {
  state->submap = SubmapArgument(session, IntArgument("go.submap", argument));
  state->node.reset();
  const Recording& recording = session.recording();
  const Submap& submap = recording.submap(*state->submap);
  const int last_node = submap.first_node.index + submap.num_nodes - 1;
  state->step =
      submap.finished_step >= 0 ? submap.finished_step : recording.node(NodeId{last_node}).step;
  FrameSelection(session, state);
}

/// To the step at which the candidate entered the graph, or came up.
void GoToLoop(const Session& session, const std::string& argument, SessionState* state) {
  const int index = LoopArgument(session, "go.loop", argument);
  const LoopCandidate& candidate = session.recording().candidates()[index];
  state->node = candidate.node;
  state->submap = candidate.submap;
  state->step = std::clamp(std::max(candidate.considered_step, candidate.applied_step), 0,
                           session.last_step());
  FrameSelection(session, state);
}

Command SelectionCommand(const char* name, const char* title, std::vector<std::string> keys,
                         const char* argument,
                         void (*change)(const Session&, const std::string&, SessionState*)) {
  const char* const menu = *argument == '\0' ? "Selection" : "";
  return StateCommand({name, title, menu, std::move(keys), argument, HasSteps, {}}, change);
}

}  // namespace

std::vector<Command> SelectionCommands() {
  return {
      SelectionCommand("select.none", "Select nothing", {"Esc"}, "",
                       [](const Session&, const std::string&, SessionState* state) {
                         state->node.reset();
                         state->submap.reset();
                         state->loops.clear();
                       }),
      SelectionCommand("select.node", "Select node", {}, "N",
                       [](const Session& session, const std::string& text, SessionState* state) {
                         state->node = NodeArgument(session, IntArgument("select.node", text));
                         state->submap.reset();
                       }),
      SelectionCommand("select.submap", "Select submap", {}, "M",
                       [](const Session& session, const std::string& text, SessionState* state) {
                         state->submap =
                             SubmapArgument(session, IntArgument("select.submap", text));
                         state->node.reset();
                       }),
      SelectionCommand("select.pair", "Select node and submap", {}, "N M",
                       [](const Session& session, const std::string& text, SessionState* state) {
                         const auto pair = NumbersArgument("select.pair", text, 2);
                         state->node = NodeArgument(session, pair[0]);
                         state->submap = SubmapArgument(session, pair[1]);
                       }),
      SelectionCommand("select.loops", "Select loop candidates", {}, "INDEX ...", SelectLoops),
      SelectionCommand("go.node", "Go to node", {}, "N", GoToNode),
      SelectionCommand("go.submap", "Go to submap", {}, "M", GoToSubmap),
      SelectionCommand("go.loop", "Go to loop candidate", {}, "INDEX", GoToLoop),
      SelectionCommand("camera.frame", "Frame the selection", {"F"}, "",
                       [](const Session& session, const std::string&, SessionState* state) {
                         FrameSelection(session, state);
                       }),
  };
}

}  // namespace loopscope
