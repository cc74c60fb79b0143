// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkSmartPointer.h>

#include "render/box.h"
#include "render/charts/chart_data.h"
#include "render/charts/chart_ticks.h"
#include "render/layers/shapes.h"
#include "render/palette.h"
#include "render/text.h"

namespace loopscope {

/// The colour of what is drawn about a subject on paper.
Color ColorOf(ChartSubject subject, const Palette& palette);

/// Where values lie in the panel of a chart.
struct ChartPlot {
  Box box;  ///< between the ends of the axes, in coordinates of the panel
  ChartAxis x;
  ChartAxis y;

  Eigen::Vector2d At(double x_value, double y_value) const {
    return {box.left + box.width * x.PlaceOf(x_value),
            box.bottom + box.height * y.PlaceOf(y_value)};
  }
  /// The values at a point of the panel.
  Eigen::Vector2d ValueAt(const Eigen::Vector2d& point) const {
    return {x.ValueAt((point.x() - box.left) / box.width),
            y.ValueAt((point.y() - box.bottom) / box.height)};
  }
};

/// A faint line across the plot at each tick, and an outline around it.
vtkSmartPointer<vtkActor> ChartGridLayer(const ChartPlot& plot,
                                         const std::vector<ChartTick>& x_ticks,
                                         const std::vector<ChartTick>& y_ticks, const Color& color,
                                         double line_width);

/// The points, the line and the bars of a series.
vtkSmartPointer<vtkActor> ChartSeriesLayer(const ChartPlot& plot, const ChartSeries& series,
                                           const Color& color, const Stroke& stroke);

/// The lines of the thresholds that lie on their axes.
vtkSmartPointer<vtkActor> ThresholdsLayer(const ChartPlot& plot,
                                          const std::vector<ChartThreshold>& thresholds,
                                          const Color& color, double line_width);

/// The numbers at the ticks, the titles of the axes and, on plates, the labels of the thresholds,
/// of which there may be two, the lesser one first. `pixel` is the length of one in the panel.
std::vector<vtkSmartPointer<vtkActor2D>> ChartTexts(const ChartPlot& plot, const ChartData& data,
                                                    const std::vector<ChartTick>& x_ticks,
                                                    const std::vector<ChartTick>& y_ticks,
                                                    const TextStyle& style, const Color& plate,
                                                    double pixel);

}  // namespace loopscope
