// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "render/scene.h"
#include "render/views/sheet.h"

namespace loopscope {

/// A point that is worth looking at.
struct PointOfInterest {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< [m]
  double weight = 0.0;  ///< the more, the more interesting; not negative
};

/// The square of edge `size` [m], out of a lattice of half that width, that holds the most weight,
/// moved to the middle of that weight. Empty if there are no points.
Extent SquareOfMostInterest(const std::vector<PointOfInterest>& points, double size);

/// The square of edge `size` [m] around `center`.
Extent SquareAround(const Eigen::Vector2d& center, double size);

/// Shows in panel 0 what is seen in `panel`, which must be open.
void OutlineCloseUp(int panel, Sheet* sheet);

}  // namespace loopscope
