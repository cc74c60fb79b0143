// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "core/graph/constraint.h"
#include "core/slam/state.h"
#include "render/layers/shapes.h"
#include "render/palette.h"

namespace loopscope {

/// Where the two ends of a constraint are and where it wants its node.
struct PlacedConstraint {
  Constraint constraint;
  Eigen::Vector2d submap;         ///< [m] in the map frame: origin of the submap
  Eigen::Vector2d node;           ///< as the state has it
  Eigen::Vector2d expected_node;  ///< as the constraint would have it, given the submap

  /// [m]
  double residual() const { return (node - expected_node).norm(); }
};

/// Those constraints of `tag` whose ends both exist in `state`.
std::vector<PlacedConstraint> PlaceConstraints(const std::vector<Constraint>& constraints,
                                               Constraint::Tag tag, const MapState& state);

/// Every k-th of `constraints`, evenly spread, so that there are at most `max_count`.
std::vector<PlacedConstraint> Thinned(const std::vector<PlacedConstraint>& constraints,
                                      int max_count);

/// The more lines there are, the clearer each is, so that what lies beneath is seen through them.
double OpacityOfMany(std::size_t num_lines);

/// A line from each submap to the expected place of its node.
vtkSmartPointer<vtkActor> InterConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                const Color& color, double line_width);

/// Likewise, each in the colour of its submap.
vtkSmartPointer<vtkActor> IntraConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                double opacity, double line_width);

/// A line from the expected to the actual place of each node.
vtkSmartPointer<vtkActor> ResidualsLayer(const std::vector<PlacedConstraint>& constraints,
                                         const Color& color, double line_width);

}  // namespace loopscope
