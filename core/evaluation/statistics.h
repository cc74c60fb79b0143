// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace loopscope {

/// Of a sample of errors, in the unit of the errors.
struct Statistics {
  int count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< with n - 1; 0 for a single value
  double rmse = 0.0;                ///< root of the mean square
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
};

/// The standard deviation with n instead of n - 1, as the TUM tools and evo have it.
double PopulationDeviation(const Statistics& statistics);

/// All zero if there are no values.
Statistics StatisticsOf(std::vector<double> values);

}  // namespace loopscope
