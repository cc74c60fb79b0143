// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/labels.h"

#include <algorithm>
#include <vtkLabeledDataMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include "render/layers/shapes.h"

namespace loopscope {
namespace {

constexpr double kPlateMargin = 2.0;  // [px] around a text

/// Where the text stands in the panel [px].
Box BoxOf(const Label& label, const FlatCamera& camera, const Box& frame, const TextStyle& style) {
  const Eigen::Vector2d anchor = (label.anchor - camera.center) / camera.meters_per_pixel +
                                 0.5 * Eigen::Vector2d(frame.width, frame.height);
  return {anchor.x() - kPlateMargin, anchor.y() - kPlateMargin,
          TextWidth(label.text, style) + 2.0 * kPlateMargin, 1.3 * style.size + 2.0 * kPlateMargin};
}

}  // namespace

Label MovedInside(const Label& label, const FlatCamera& camera, const Box& frame,
                  const TextStyle& style) {
  constexpr double kRounding = 0.5;  // [px] that a text may reach out of a panel otherwise
  const Box box = BoxOf(label, camera, frame, style);
  const auto move = [](double low, double size, double room) {
    return std::max(kRounding - low, std::min(0.0, room - kRounding - low - size));
  };
  const Eigen::Vector2d moved(move(box.left, box.width, frame.width),
                              move(box.bottom, box.height, frame.height));
  return {label.anchor + camera.meters_per_pixel * moved, label.text};
}

std::vector<Label> WithoutOverlaps(const std::vector<Label>& labels, const FlatCamera& camera,
                                   const Box& frame, const TextStyle& style) {
  const Box panel{0.0, 0.0, frame.width, frame.height};
  std::vector<Box> taken;
  std::vector<Label> kept;
  for (const Label& label : labels) {
    const Box box = BoxOf(label, camera, frame, style);
    const bool inside = box.left >= 0.0 && box.bottom >= 0.0 && box.right() <= panel.width &&
                        box.top() <= panel.height;
    const auto touches = [&](const Box& other) { return Overlap(box, other); };
    if (!inside || std::any_of(taken.begin(), taken.end(), touches)) continue;
    taken.push_back(box);
    kept.push_back(label);
  }
  return kept;
}

vtkSmartPointer<vtkActor2D> LabelsLayer(const std::vector<Label>& labels, const TextStyle& style,
                                        const Color& plate) {
  Shapes anchors;
  vtkNew<vtkStringArray> texts;
  texts->SetName("text");
  for (const Label& label : labels) {
    anchors.SetHeight(label.height);
    anchors.AddPoint(label.anchor, style.color);
    texts->InsertNextValue(label.text);
  }
  const vtkSmartPointer<vtkPolyData> data = anchors.Build();
  data->GetPointData()->AddArray(texts);
  const auto property = MakeTextProperty(style, Align::kLeft);
  property->SetVerticalJustificationToBottom();
  property->SetBackgroundColor(plate.r / 255.0, plate.g / 255.0, plate.b / 255.0);
  property->SetBackgroundOpacity(plate.a / 255.0);
  vtkNew<vtkLabeledDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLabelModeToLabelFieldData();
  mapper->SetFieldDataName("text");
  mapper->SetLabelTextProperty(property);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  return actor;
}

}  // namespace loopscope
