// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/chart_layers.h"

#include <algorithm>
#include <utility>

#include "render/layers/labels.h"

namespace loopscope {
namespace {

using Vector = Eigen::Vector2d;

bool IsOn(const ChartAxis& axis, double value) { return axis.min <= value && value <= axis.max; }

/// Collects texts at places of the panel.
class TextPlacer {
 public:
  TextPlacer(const TextStyle& style, double pixel) : style_(style), pixel_(pixel) {}

  /// `align` of the text, 0 to 1, stands to the left of `place`, and its lower edge so many heights
  /// above it; by default it is centered on it.
  void Write(const std::string& text, const Vector& place, double align, double rise = -0.6) {
    const Vector shift(-align * TextWidth(text, style_), rise * style_.size);
    labels_.push_back({place + pixel_ * shift, text});
  }

  /// So many heights of the text in the coordinates of the panel.
  double Em(double count) const { return count * style_.size * pixel_; }

  double Width(const std::string& text) const { return pixel_ * TextWidth(text, style_); }

  const std::vector<Label>& labels() const { return labels_; }

 private:
  const TextStyle& style_;
  double pixel_;
  std::vector<Label> labels_;
};

std::vector<Label> AxisLabels(const ChartPlot& plot, const std::vector<ChartTick>& x_ticks,
                              const std::vector<ChartTick>& y_ticks, const TextStyle& style,
                              double pixel) {
  TextPlacer placer(style, pixel);
  const Box& box = plot.box;
  for (const ChartTick& tick : x_ticks) {
    const double x = plot.At(tick.value, plot.y.min).x();
    placer.Write(tick.label, {x, box.bottom - placer.Em(0.9)}, 0.5);
  }
  for (const ChartTick& tick : y_ticks) {
    const double y = plot.At(plot.x.min, tick.value).y();
    placer.Write(tick.label, {box.left - placer.Em(0.5), y}, 1.0);
  }
  placer.Write(plot.x.title, {box.center_x(), box.bottom - placer.Em(2.3)}, 0.5);
  placer.Write(plot.y.title, {box.left, box.top() + placer.Em(0.9)}, 0.0);
  return placer.labels();
}

std::vector<Label> ThresholdLabels(const ChartPlot& plot,
                                   const std::vector<ChartThreshold>& thresholds,
                                   const TextStyle& style, double pixel) {
  TextPlacer placer(style, pixel);
  for (const ChartThreshold& threshold : thresholds) {
    if (!IsOn(threshold.upright ? plot.x : plot.y, threshold.value)) continue;
    const bool is_last = &threshold == &thresholds.back();
    if (!threshold.upright) {
      const Vector end(plot.box.right() - placer.Em(0.4), plot.At(0.0, threshold.value).y());
      placer.Write(threshold.label, end, 1.0, is_last ? 0.3 : -1.5);
      continue;
    }
    const double x = plot.At(threshold.value, plot.y.min).x();
    const double y = plot.box.top() - placer.Em(0.9);
    if (is_last) {
      const double rightmost = plot.box.right() - placer.Width(threshold.label);
      placer.Write(threshold.label, {std::min(x + placer.Em(0.4), rightmost), y}, 0.0);
    } else {
      placer.Write(threshold.label, {x - placer.Em(0.4), y}, 1.0);
    }
  }
  return placer.labels();
}

}  // namespace

Color ColorOf(ChartSubject subject, const Palette& palette) {
  switch (subject) {
    case ChartSubject::kAccepted:
    case ChartSubject::kAfter:
      return palette.refined;
    case ChartSubject::kInconsistent:
      return palette.correlative;
    case ChartSubject::kAmbiguous:
    case ChartSubject::kBefore:
      return palette.prior;
    case ChartSubject::kBelowMinScore:
      return palette.too_low;
    case ChartSubject::kFromBehind:
    case ChartSubject::kWorst:
      return palette.hit;
    case ChartSubject::kMean:
      break;
  }
  return palette.window;
}

vtkSmartPointer<vtkActor> ChartGridLayer(const ChartPlot& plot,
                                         const std::vector<ChartTick>& x_ticks,
                                         const std::vector<ChartTick>& y_ticks, const Color& color,
                                         double line_width) {
  Shapes shapes;
  const Color faint = WithOpacity(color, 0.45);
  for (const ChartTick& tick : x_ticks) {
    const double x = plot.At(tick.value, plot.y.min).x();
    shapes.AddLine({x, plot.box.bottom}, {x, plot.box.top()}, faint);
  }
  for (const ChartTick& tick : y_ticks) {
    const double y = plot.At(plot.x.min, tick.value).y();
    shapes.AddLine({plot.box.left, y}, {plot.box.right(), y}, faint);
  }
  shapes.AddOutline(RectangleCorners(Pose2(), {plot.box.left, plot.box.bottom},
                                     {plot.box.right(), plot.box.top()}),
                    color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> ChartSeriesLayer(const ChartPlot& plot, const ChartSeries& series,
                                           const Color& color, const Stroke& stroke) {
  Shapes shapes;
  std::vector<Vector> corners;
  for (const ChartPoint& point : series.points) {
    corners.push_back(plot.At(point.x, point.y));
    shapes.AddPoint(corners.back(), color);
  }
  if (series.joined) shapes.AddPolyline(corners, color);
  for (const ChartBar& bar : series.bars) {
    shapes.AddPolygon(
        RectangleCorners(Pose2(), plot.At(bar.begin, bar.low), plot.At(bar.end, bar.high)), color);
  }
  return MakeActor(shapes.Build(), stroke);
}

vtkSmartPointer<vtkActor> ThresholdsLayer(const ChartPlot& plot,
                                          const std::vector<ChartThreshold>& thresholds,
                                          const Color& color, double line_width) {
  Shapes shapes;
  for (const ChartThreshold& threshold : thresholds) {
    if (!IsOn(threshold.upright ? plot.x : plot.y, threshold.value)) continue;
    const double v = threshold.value;
    const Vector from = threshold.upright ? plot.At(v, plot.y.min) : plot.At(plot.x.min, v);
    const Vector to = threshold.upright ? plot.At(v, plot.y.max) : plot.At(plot.x.max, v);
    shapes.AddLine(from, to, color);
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

std::vector<vtkSmartPointer<vtkActor2D>> ChartTexts(const ChartPlot& plot, const ChartData& data,
                                                    const std::vector<ChartTick>& x_ticks,
                                                    const std::vector<ChartTick>& y_ticks,
                                                    const TextStyle& style, const Color& plate,
                                                    double pixel) {
  return {LabelsLayer(AxisLabels(plot, x_ticks, y_ticks, style, pixel), style, {0, 0, 0, 0}),
          LabelsLayer(ThresholdLabels(plot, data.thresholds, style, pixel), style, plate)};
}

}  // namespace loopscope
