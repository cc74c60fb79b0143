// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/constraints.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

std::vector<PlacedConstraint> PlaceConstraints(const std::vector<Constraint>& constraints,
                                               Constraint::Tag tag, const MapState& state) {
  std::vector<PlacedConstraint> placed;
  for (const Constraint& constraint : constraints) {
    const bool exists =
        constraint.submap.index < state.num_submaps && constraint.node.index < state.num_nodes;
    if (constraint.tag != tag || !exists) continue;
    const Pose2& global_from_submap = state.global_from_submap[constraint.submap.index];
    placed.push_back({constraint, global_from_submap.translation,
                      state.global_from_node[constraint.node.index].translation,
                      global_from_submap * constraint.submap_from_node.translation});
  }
  return placed;
}

std::vector<PlacedConstraint> Thinned(const std::vector<PlacedConstraint>& constraints,
                                      int max_count) {
  const std::size_t max_size = static_cast<std::size_t>(max_count);
  const std::size_t step = (constraints.size() + max_size - 1) / max_size;
  std::vector<PlacedConstraint> some;
  for (std::size_t i = 0; i < constraints.size(); i += step) some.push_back(constraints[i]);
  return some;
}

double OpacityOfMany(std::size_t num_lines) {
  return std::clamp(10.0 / std::sqrt(static_cast<double>(num_lines) + 1.0), 0.2, 0.7);
}

vtkSmartPointer<vtkActor> InterConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                const Color& color, double line_width) {
  Shapes shapes;
  for (const PlacedConstraint& c : constraints) shapes.AddLine(c.submap, c.expected_node, color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> IntraConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                double opacity, double line_width) {
  Shapes shapes;
  for (const PlacedConstraint& c : constraints) {
    shapes.AddLine(c.submap, c.expected_node,
                   WithOpacity(HueOf(c.constraint.submap.index), opacity));
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> ResidualsLayer(const std::vector<PlacedConstraint>& constraints,
                                         const Color& color, double line_width) {
  Shapes shapes;
  for (const PlacedConstraint& c : constraints) shapes.AddLine(c.expected_node, c.node, color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
