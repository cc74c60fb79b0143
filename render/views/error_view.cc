// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/error_view.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/charts/error_histogram.h"
#include "render/layers/trajectory.h"
#include "render/number_text.h"
#include "render/views/chart_drawing.h"
#include "render/views/grids.h"
#include "render/views/pose_layers.h"
#include "render/views/sheet.h"

namespace loopscope {
namespace {

std::vector<double> TranslationsOf(const RunErrors& errors) {
  std::vector<double> values;
  for (const ErrorSample& sample : errors.samples) values.push_back(sample.translation);
  return values;
}

std::vector<double> DegreesOf(const RunErrors& errors) {
  std::vector<double> values;
  for (const ErrorSample& sample : errors.samples) {
    values.push_back(RadiansToDegrees(sample.rotation));
  }
  return values;
}

bool HasLarger(const std::vector<double>& values, double scale) {
  return std::any_of(values.begin(), values.end(), [scale](double value) { return value > scale; });
}

ColorBar ErrorBar(double scale, const Palette& palette) {
  return {
      "error [m]",
      palette.error,
      {{0.0, "0"}, {0.5, fmt::format("{:g}", 0.5 * scale)}, {1.0, fmt::format("{:g}+", scale)}}};
}

LayerKeys KeysOf(const RunErrors& errors, double scale, const Palette& palette) {
  LayerKeys keys;
  if (!errors.reference.empty()) {
    keys.legend.push_back(
        {LayerKind::kTrajectory,
         {{Swatch::Kind::kLine, palette.faint_ink, palette.map_free}, "reference"}});
  }
  keys.color_bars.push_back({LayerKind::kNodes, ErrorBar(scale, palette)});
  return keys;
}

Annotation Describe(const RunErrors& errors, bool has_larger) {
  Annotation annotation;
  annotation.title = "Errors";
  annotation.subtitle = {errors.run, errors.measure};
  annotation.facts = {{"samples", CountText(static_cast<double>(errors.samples.size()))}};
  if (errors.samples.empty()) return annotation;
  const auto worst =
      std::max_element(errors.samples.begin(), errors.samples.end(),
                       [](const auto& a, const auto& b) { return a.translation < b.translation; });
  annotation.facts.push_back({"worst", LengthText(worst->translation)});
  annotation.facts.push_back(
      {"at", fmt::format("({:.1f}, {:.1f}) m", worst->position.x(), worst->position.y())});
  if (has_larger) annotation.facts.push_back({"last bars", "and more"});
  return annotation;
}

Extent ExtentOf(const RunErrors& errors) {
  Extent extent;
  for (const Pose2& pose : errors.way) extent.extend(pose.translation);
  for (const Pose2& pose : errors.reference) extent.extend(pose.translation);
  return extent;
}

std::vector<PlacedGrid> GridsOf(const Recording* recording) {
  if (recording == nullptr) return {};
  DerivedCache cache(*recording);
  return PlacedGridsOf(&cache, StateAfterStep(*recording, recording->num_steps() - 1));
}

/// Dots of the samples, the worst on top.
vtkSmartPointer<vtkActor> SamplesLayer(const RunErrors& errors, double scale,
                                       const ColorMap& colors, double size) {
  std::vector<ErrorSample> samples = errors.samples;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const auto& a, const auto& b) { return a.translation < b.translation; });
  Shapes shapes;
  for (const ErrorSample& sample : samples) {
    shapes.AddPoint(sample.position, colors.At(sample.translation / scale));
  }
  return MakeActor(shapes.Build(), {1.0, size, true});
}

void DrawSamples(const RunErrors& errors, double scale, Sheet* sheet) {
  const std::vector<PlacedGrid> grids = GridsOf(errors.recording);
  const MapColors colors = PlainMapColors(sheet->palette());
  Extent extent = ExtentOf(errors);
  extent.extend(ExtentOf(grids));
  sheet->Open(0, extent, grids.empty() ? sheet->palette().paper : colors.unknown);
  MapComposer composer;
  if (!grids.empty()) DrawMap(grids, colors, &composer, sheet);
  const Color faint = sheet->palette().faint_ink;
  sheet->Add(0, LayerKind::kTrajectory, [&] {
    return TrajectoryLayer(errors.way, WithOpacity(faint, 0.4), sheet->Px(widths::kHairline));
  });
  sheet->Add(0, LayerKind::kTrajectory,
             [&] { return TrajectoryLayer(errors.reference, faint, sheet->Px(widths::kThin)); });
  sheet->Add(0, LayerKind::kNodes, [&] {
    return SamplesLayer(errors, scale, sheet->palette().error, sheet->Px(1.8 * widths::kNode));
  });
}

}  // namespace

Scene BuildErrorView(const RunErrors& errors, const ViewRequest& request, int oversampling) {
  ViewRequest style = request;
  style.layers = {LayerKind::kGrid, LayerKind::kTrajectory, LayerKind::kNodes, LayerKind::kScan,
                  LayerKind::kLabels};
  const std::vector<double> translations = TranslationsOf(errors);
  const std::vector<double> degrees = DegreesOf(errors);
  const double scale = ErrorScaleOf(translations);
  const double degree_scale = ErrorScaleOf(degrees);
  const bool has_larger = HasLarger(translations, scale) || HasLarger(degrees, degree_scale);
  Arrangement arrangement;
  arrangement.num_side_panels = 2;
  Sheet sheet(style, oversampling, Describe(errors, has_larger),
              KeysOf(errors, scale, PaletteOf(style.theme)), arrangement);
  DrawSamples(errors, scale, &sheet);
  if (sheet.num_panels() == 3) {
    DrawChart(ErrorHistogram("translation [m]", translations, scale), 1, sheet.OpenChart(1, {}),
              &sheet);
    DrawChart(ErrorHistogram("rotation [deg]", degrees, degree_scale), 2, sheet.OpenChart(2, {}),
              &sheet);
  }
  return sheet.Finish();
}

}  // namespace loopscope
