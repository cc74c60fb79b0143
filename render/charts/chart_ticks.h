// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/charts/chart_data.h"

namespace loopscope {

struct ChartTick {
  double value = 0.0;
  std::string label;
};

/// Round values on the axis: powers of ten on a logarithmic one, else some `count` multiples of 1,
/// 2 or 5 times a power of ten. The least is first.
std::vector<ChartTick> TicksOf(const ChartAxis& axis, int count);

}  // namespace loopscope
