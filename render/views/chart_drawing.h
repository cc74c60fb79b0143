// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include "render/charts/chart_data.h"
#include "render/views/sheet.h"

namespace loopscope {

/// Whether anything of a series is drawn.
bool HasContent(const ChartSeries& series);

/// The legend of all charts of a sheet: each series that has content.
LayerKeys KeysOf(const std::vector<const ChartData*>& charts, const Palette& palette);

/// Draws a chart into a panel that was opened for one, `width` as Sheet::OpenChart returned it. The
/// points of the loop candidates `marked` get a ring.
void DrawChart(const ChartData& data, int panel, double width, Sheet* sheet,
               const std::set<int>& marked = {});

}  // namespace loopscope
