// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace loopscope {

enum class ChartKind {
  kScores,             ///< of every search against its min_score, over the steps
  kScoreHistogram,     ///< of the searches, by verdict
  kResiduals,          ///< of the loops after each optimization, over the steps
  kResidualHistogram,  ///< of the loops as they are now
  kCosts,              ///< of each optimization, before and after
};

/// "scores", "score-histogram", "residuals", "residual-histogram" or "costs". Throws
/// std::invalid_argument naming these for anything else.
ChartKind ChartKindFromName(const std::string& name);
std::string ToString(ChartKind kind);

/// What a series is about; its colour follows from it.
enum class ChartSubject {
  kAccepted,
  kInconsistent,
  kAmbiguous,
  kFromBehind,
  kBelowMinScore,
  kWorst,
  kMean,
  kBefore,
  kAfter
};

struct ChartAxis {
  std::string title;  ///< with its unit
  double min = 0.0;
  double max = 1.0;
  bool logarithmic = false;  ///< then min > 0

  /// Of `value` along the axis: 0 at min, 1 at max. What is below the axis is at its beginning.
  double PlaceOf(double value) const;
  /// The value at `place`, likewise.
  double ValueAt(double place) const;
};

struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
  int candidate = -1;  ///< index of the loop candidate that it stands for; -1: none
};

/// From y = low to high over x = begin to end. Bars of several series stand on each other.
struct ChartBar {
  double begin = 0.0;
  double end = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct ChartSeries {
  ChartSubject subject = ChartSubject::kAccepted;
  std::string name;
  std::vector<ChartPoint> points;
  bool joined = false;  ///< points are the corners of a line
  std::vector<ChartBar> bars;
};

/// A line across the chart at a value that decides something.
struct ChartThreshold {
  double value = 0.0;
  bool upright = false;  ///< at x = value instead of y = value
  std::string label;
};

/// All that a chart shows, without how it is drawn.
struct ChartData {
  std::string title;
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series;  ///< later ones cover earlier ones
  std::vector<ChartThreshold> thresholds;
};

/// The point nearest to (x, y), in the coordinates of the axes, if it is no farther away than a
/// fiftieth of them.
std::optional<ChartPoint> PointAt(const ChartData& data, double x, double y);

/// The bar at (x, y), in the coordinates of the axes.
std::optional<ChartBar> BarAt(const ChartData& data, double x, double y);

}  // namespace loopscope
