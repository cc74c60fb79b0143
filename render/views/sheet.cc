// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/sheet.h"

#include <algorithm>

#include "render/annotation_layer.h"
#include "render/layers/opacity.h"

namespace loopscope {

Sheet::Sheet(const ViewRequest& request, int oversampling, Annotation annotation,
             const LayerKeys& keys, const Arrangement& arrangement)
    : request_(request),
      palette_(PaletteOf(request.theme)),
      oversampling_(oversampling),
      shown_(request.layers.value_or(DefaultLayersOf(request.view))),
      annotation_(Complete(std::move(annotation), keys)),
      layout_(
          LayOut(MakeSheetSize(request.width, request.height, oversampling, request.text_height),
                 annotation_, arrangement)),
      drafts_(layout_.panels.size()) {}

Annotation Sheet::Complete(Annotation annotation, const LayerKeys& keys) const {
  if (!request_.title.empty()) annotation.title = ToUtf8(request_.title);
  if (request_.plain) {
    annotation.subtitle.clear();
    annotation.facts.clear();
    return annotation;
  }
  for (std::string& part : annotation.subtitle) part = ToUtf8(part);
  for (const auto& [kind, entry] : keys.legend) {
    if (Shows(kind)) annotation.legend.push_back(entry);
  }
  for (const auto& [kind, bar] : keys.color_bars) {
    if (Shows(kind)) annotation.color_bars.push_back(bar);
  }
  return annotation;
}

void Sheet::Open(int panel, const Extent& extent, const Color& canvas,
                 std::vector<std::string> caption) {
  PanelDraft& draft = drafts_[panel];
  draft.camera = CameraFor(extent, frame(panel));
  draft.canvas = canvas;
  draft.caption = std::move(caption);
  if (panel != 0) return;
  if (request_.center) draft.camera.center = *request_.center;
  if (!request_.width_in_meters && !request_.height_in_meters) return;
  draft.camera.meters_per_pixel =
      std::max(request_.width_in_meters.value_or(0.0) / frame(panel).width,
               request_.height_in_meters.value_or(0.0) / frame(panel).height);
}

void Sheet::OpenFrom(const SideView& side, int panel, const Extent& extent, const Color& canvas,
                     std::vector<std::string> caption) {
  Open(panel, extent, canvas, std::move(caption));
  drafts_[panel].side = side;
  drafts_[panel].is_map = false;
}

double Sheet::OpenChart(int panel, std::vector<std::string> caption) {
  const Box& box = frame(panel);
  const double width = box.width / box.height;
  Open(panel, Extent(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(width, 1.0)), palette_.paper,
       std::move(caption));
  drafts_[panel].is_map = false;
  return width;
}

void Sheet::Put(int panel, const LayerProp& layer) {
  const auto opacity = request_.opacities.find(layer.kind);
  if (opacity != request_.opacities.end()) MultiplyOpacity(opacity->second, layer.prop);
  drafts_[panel].layers.emplace(layer.kind, layer);
}

Panel Sheet::FinishPanel(int index) const {
  const PanelDraft& draft = drafts_[index];
  Panel panel{frame(index), draft.camera, draft.canvas, {}, draft.is_map, draft.side};
  for (const auto& [kind, layer] : draft.layers) panel.props.push_back(layer);
  panel.edge = [boxes = layout_.panels[index], has_scale = draft.is_map, caption = draft.caption,
                size = layout_.size, &palette = palette_](const FlatCamera& camera) {
    return DrawPanelEdge(boxes, has_scale ? &camera : nullptr, caption, size, palette);
  };
  return panel;
}

Scene Sheet::Finish() const {
  Scene scene;
  scene.width = layout_.size.width;
  scene.height = layout_.size.height;
  scene.oversampling = oversampling_;
  scene.paper = palette_.paper;
  scene.annotation = DrawAnnotation(annotation_, layout_, palette_);
  for (int i = 0; i < num_panels(); ++i) scene.panels.push_back(FinishPanel(i));
  return scene;
}

}  // namespace loopscope
