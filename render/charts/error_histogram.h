// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/charts/chart_data.h"

namespace loopscope {

/// The least of 1, 2 or 5 times a power of ten that no more than a twentieth of `values` exceeds;
/// 1 if there are none but zeros.
double ErrorScaleOf(std::vector<double> values);

/// How often errors were how large, in 40 bars from 0 to `max` > 0; the last one counts larger ones
/// as well. A line marks the root mean square.
ChartData ErrorHistogram(const std::string& title, const std::vector<double>& values, double max);

}  // namespace loopscope
