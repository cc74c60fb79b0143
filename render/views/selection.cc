// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/selection.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace loopscope {
namespace {

[[noreturn]] void Refuse(const std::string& what) { throw std::invalid_argument(what); }

/// "none", "0" or "0 to 41": the indices of `count` things.
std::string Range(int count) {
  if (count == 0) return "there is none";
  return count == 1 ? "expected 0" : fmt::format("expected 0 to {}", count - 1);
}

bool Fits(const LoopCandidate& candidate, const ViewRequest& request) {
  return candidate.verdict != Verdict::kNotSampled &&
         (!request.node || *request.node == candidate.node) &&
         (!request.submap || *request.submap == candidate.submap);
}

/// Whether `a` is the more telling search: accepted before refused, then the higher score.
bool IsBetter(const LoopCandidate& a, const LoopCandidate& b) {
  const bool a_accepted = a.verdict == Verdict::kAccepted;
  const bool b_accepted = b.verdict == Verdict::kAccepted;
  return a_accepted != b_accepted ? a_accepted : a.score > b.score;
}

bool IsOfOneScan(ViewKind view) { return view == ViewKind::kUpdate || view == ViewKind::kMatch; }

}  // namespace

void RequireNode(const Recording& recording, NodeId node) {
  const int count = static_cast<int>(recording.nodes().size());
  if (node.index < 0 || node.index >= count) {
    Refuse(fmt::format("no node {}: {}", node.index, Range(count)));
  }
}

void RequireSubmap(const Recording& recording, SubmapId submap) {
  const int count = static_cast<int>(recording.submaps().size());
  if (submap.index < 0 || submap.index >= count) {
    Refuse(fmt::format("no submap {}: {}", submap.index, Range(count)));
  }
}

int StepOf(const Recording& recording, const ViewRequest& request) {
  const int count = recording.num_steps();
  if (request.step && (*request.step < 0 || *request.step >= count)) {
    Refuse(fmt::format("no step {}: {}", *request.step, Range(count)));
  }
  if (count == 0) Refuse("nothing to draw: the recording has no steps");
  if (request.step) return *request.step;
  if (!request.node || !IsOfOneScan(request.view)) return count - 1;
  RequireNode(recording, *request.node);
  return recording.node(*request.node).step;
}

NodeId NodeOf(const Recording& recording, const ViewRequest& request) {
  const int step = StepOf(recording, request);
  if (request.node) {
    RequireNode(recording, *request.node);
    return *request.node;
  }
  const auto& nodes = recording.nodes();
  const auto end =
      std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.step > step; });
  if (end == nodes.begin()) {
    throw NothingToShow(
        fmt::format("no node until step {}: expected a step after the first insertion", step));
  }
  return NodeId{static_cast<int>(end - nodes.begin()) - 1};
}

SubmapId SubmapOf(const Recording& recording, const ViewRequest& request) {
  const int step = StepOf(recording, request);
  const auto& submaps = recording.submaps();
  if (request.submap) {
    RequireSubmap(recording, *request.submap);
    const int begun = recording.node(recording.submap(*request.submap).first_node).step;
    if (begun > step) {
      throw NothingToShow(
          fmt::format("submap {} was begun at step {}: expected that step or a later one",
                      request.submap->index, begun));
    }
    return *request.submap;
  }
  std::optional<SubmapId> last_finished;
  std::optional<SubmapId> last_begun;
  for (SubmapId id{0}; id.index < static_cast<int>(submaps.size()); ++id.index) {
    const Submap& submap = recording.submap(id);
    if (recording.node(submap.first_node).step <= step) last_begun = id;
    if (submap.finished_step >= 0 && submap.finished_step <= step) last_finished = id;
  }
  if (!last_begun) {
    throw NothingToShow(fmt::format("no submap until step {}: expected a later step", step));
  }
  return last_finished.value_or(*last_begun);
}

SubmapId SubmapOfNode(const Recording& recording, const ViewRequest& request, NodeId node) {
  const Node& record = recording.node(node);
  if (!request.submap) return record.first_submap;
  if (!record.LiesIn(*request.submap)) {
    Refuse(fmt::format("node {} is not in submap {}: expected one of submaps {} to {}", node.index,
                       request.submap->index, record.first_submap.index,
                       record.first_submap.index + record.num_submaps - 1));
  }
  return *request.submap;
}

std::pair<SubmapId, NodeId> SearchedPairOf(const Recording& recording, const ViewRequest& request) {
  if (request.node) RequireNode(recording, *request.node);
  if (request.submap) RequireSubmap(recording, *request.submap);
  if (request.node && request.submap) return {*request.submap, *request.node};
  ViewRequest until = request;
  until.node.reset();
  const int step = StepOf(recording, until);
  const LoopCandidate* best = nullptr;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (candidate.applied_step > step || !Fits(candidate, request)) continue;
    if (best == nullptr || IsBetter(candidate, *best)) best = &candidate;
  }
  if (best == nullptr) {
    const std::string of = request.node     ? fmt::format(" of node {}", request.node->index)
                           : request.submap ? fmt::format(" in submap {}", request.submap->index)
                                            : "";
    throw NothingToShow(
        fmt::format("no loop search{} until step {}: expected both a node and a submap", of, step));
  }
  return {best->submap, best->node};
}

std::vector<std::string> Subtitle(const Recording& recording, int step,
                                  const std::vector<std::string>& ids) {
  const auto& scans = recording.log().scans;
  std::vector<std::string> parts{recording.log().name,
                                 fmt::format("step {} of {}", step, recording.num_steps() - 1)};
  parts.insert(parts.end(), ids.begin(), ids.end());
  parts.push_back(fmt::format("{:.1f} s", scans[step].time - scans.front().time));
  return parts;
}

}  // namespace loopscope
