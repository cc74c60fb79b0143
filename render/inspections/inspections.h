// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "core/grid/probability_grid.h"
#include "render/inspection.h"

namespace loopscope {

/// Answers for a panel, a point and a tolerance, see Inspector::WhatIsAt.
using Look = std::function<std::optional<Finding>(int, const Eigen::Vector2d&, double)>;

// One function for each kind of view, or two that look alike. Each copies what its answers need.

Look InspectGraph(const Recording& recording, const ViewRequest& request);
Look InspectSubmap(const Recording& recording, const ViewRequest& request);
Look InspectUpdate(const Recording& recording, const ViewRequest& request);
Look InspectMatch(const Recording& recording, const ViewRequest& request);
/// `aspect` is the width over the height of the chart.
Look InspectSearch(DerivedCache* cache, const ViewRequest& request, double aspect);
Look InspectChart(const Recording& recording, const ViewRequest& request, const Scene& scene);

/// Index and probability of the cell at `point`, or that no scan has seen it.
std::vector<Fact> CellFacts(const ProbabilityGrid& grid, const Eigen::Vector2d& point);

/// "1.63"
std::string OddsText(double odds);

}  // namespace loopscope
