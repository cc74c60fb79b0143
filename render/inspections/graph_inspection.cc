// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "core/slam/state.h"
#include "render/inspections/inspections.h"
#include "render/layers/constraints.h"
#include "render/number_text.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

using Tag = Constraint::Tag;

/// What can be found in a map, as it was after a step.
struct Things {
  MapState state;
  std::vector<Node> nodes;
  std::vector<Submap> submaps;
  std::vector<LoopCandidate> candidates;
  std::vector<PlacedConstraint> inter;  ///< if they are drawn
  std::vector<PlacedConstraint> intra;  ///< likewise
};

double DistanceToLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                      const Eigen::Vector2d& point) {
  const Eigen::Vector2d way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0.0 ? std::clamp(way.dot(point - from) / length, 0.0, 1.0) : 0.0;
  return (point - from - share * way).norm();
}

/// The index below `count` with the least distance, if that is within `tolerance`.
template <typename DistanceOf>
std::optional<int> Nearest(int count, double tolerance, const DistanceOf& distance_of) {
  std::optional<int> nearest;
  double least = tolerance;
  for (int i = 0; i < count; ++i) {
    const double distance = distance_of(i);
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

std::vector<Fact> PoseFacts(const Pose2& global_from_it) {
  return {{"x", fmt::format("{:.2f} m", global_from_it.x())},
          {"y", fmt::format("{:.2f} m", global_from_it.y())},
          {"heading", AngleText(global_from_it.rotation)}};
}

void Append(const std::vector<Fact>& more, std::vector<Fact>* facts) {
  facts->insert(facts->end(), more.begin(), more.end());
}

Finding FindingOf(const Things& things, NodeId id) {
  const Node& node = things.nodes[id.index];
  Finding finding{id, std::nullopt, {{"node", ToString(id)}}};
  finding.facts.push_back({"step", std::to_string(node.step)});
  Append(PoseFacts(things.state.global_from_node[id.index]), &finding.facts);
  for (int i = 0; i < node.num_submaps; ++i) {
    finding.facts.push_back({"in submap", ToString(SubmapId{node.first_submap.index + i})});
  }
  return finding;
}

Finding FindingOf(const Things& things, SubmapId id) {
  const Submap& submap = things.submaps[id.index];
  const bool finished = submap.finished_step >= 0 && submap.finished_step <= things.state.step;
  Finding finding{std::nullopt, id, {{"submap", ToString(id)}}};
  finding.facts.push_back(
      {"finished", finished ? fmt::format("step {}", submap.finished_step) : "not yet"});
  Append(PoseFacts(things.state.global_from_submap[id.index]), &finding.facts);
  return finding;
}

Finding FindingOf(const Things& things, const PlacedConstraint& placed) {
  const Constraint& constraint = placed.constraint;
  const bool is_loop = constraint.tag == Tag::kInterSubmap;
  const Pose2 submap_from_node =
      things.state.global_from_submap[constraint.submap.index].Inverse() *
      things.state.global_from_node[constraint.node.index];
  const Pose2 error = constraint.submap_from_node.Inverse() * submap_from_node;
  Finding finding{constraint.node, constraint.submap, {}};
  finding.facts = {{"constraint", is_loop ? "INTER" : "INTRA"},
                   {"node", ToString(constraint.node)},
                   {"submap", ToString(constraint.submap)},
                   {"residual", LengthText(placed.residual())},
                   {"turned", AngleText(error.rotation)}};
  if (!is_loop) return finding;
  for (const LoopCandidate& candidate : things.candidates) {
    if (candidate.verdict == Verdict::kAccepted && candidate.node == constraint.node &&
        candidate.submap == constraint.submap) {
      finding.facts.push_back({"score", fmt::format("{:.3f}", candidate.score)});
      break;
    }
  }
  return finding;
}

std::optional<Finding> FindIn(const Things& things, const Eigen::Vector2d& point,
                              double tolerance) {
  const MapState& state = things.state;
  const auto node = Nearest(state.num_nodes, tolerance, [&](int i) {
    return (state.global_from_node[i].translation - point).norm();
  });
  if (node) return FindingOf(things, NodeId{*node});
  for (const auto* constraints : {&things.inter, &things.intra}) {
    const auto found = Nearest(static_cast<int>(constraints->size()), tolerance, [&](int i) {
      const PlacedConstraint& placed = (*constraints)[i];
      return DistanceToLine(placed.submap, placed.expected_node, point);
    });
    if (found) return FindingOf(things, (*constraints)[*found]);
  }
  const auto submap = Nearest(state.num_submaps, tolerance, [&](int i) {
    return (state.global_from_submap[i].translation - point).norm();
  });
  if (submap) return FindingOf(things, SubmapId{*submap});
  return std::nullopt;
}

}  // namespace

Look InspectGraph(const Recording& recording, const ViewRequest& request) {
  auto things = std::make_shared<Things>();
  things->state = StateAfterStep(recording, StepOf(recording, request));
  things->nodes = recording.nodes();
  things->submaps = recording.submaps();
  things->candidates = recording.candidates();
  const std::set<LayerKind> shown = request.layers.value_or(DefaultLayersOf(request.view));
  const std::vector<Constraint> constraints = ConstraintsOf(recording, things->state);
  if (shown.count(LayerKind::kInter) > 0) {
    things->inter = PlaceConstraints(constraints, Tag::kInterSubmap, things->state);
  }
  if (shown.count(LayerKind::kIntra) > 0) {
    things->intra = PlaceConstraints(constraints, Tag::kIntraSubmap, things->state);
  }
  return [things](int, const Eigen::Vector2d& point, double tolerance) {
    return FindIn(*things, point, tolerance);
  };
}

}  // namespace loopscope
