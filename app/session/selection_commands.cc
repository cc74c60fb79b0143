// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>

#include "app/session/command_groups.h"
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

/// Shows what is selected with some metres around it in the views of the whole map; all of the map
/// if nothing is selected.
void FrameSelection(const Session& session, SessionState* state) {
  constexpr double kAround = 1.6;
  constexpr double kMinWidth = 8.0;  // [m]
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
    camera = ViewCamera{box.center(), std::max(kMinWidth, kAround * 2.0 * box.sizes().maxCoeff())};
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
  state->step = submap.finished_step >= 0 ? submap.finished_step
                                          : recording.node(NodeId{last_node}).step;
  FrameSelection(session, state);
}

/// To the step at which the candidate entered the graph, or came up.
void GoToLoop(const Session& session, const std::string& argument, SessionState* state) {
  const auto& candidates = session.recording().candidates();
  const int index = Existing("loop", IntArgument("go.loop", argument), candidates.size());
  const LoopCandidate& candidate = candidates[index];
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
      SelectionCommand("select.loop", "Select the pair of a loop candidate", {}, "INDEX",
                       [](const Session& session, const std::string& text, SessionState* state) {
                         const auto& candidates = session.recording().candidates();
                         const int index = Existing("loop", IntArgument("select.loop", text),
                                                    candidates.size());
                         state->node = candidates[index].node;
                         state->submap = candidates[index].submap;
                       }),
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
