// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "render/annotation.h"
#include "render/layers/map_image.h"
#include "render/layout.h"
#include "render/scene.h"
#include "render/view.h"

namespace loopscope {

/// What the layers of a picture look like. Only those that are drawn are explained.
struct LayerKeys {
  std::vector<std::pair<LayerKind, LegendEntry>> legend;
  std::vector<std::pair<LayerKind, ColorBar>> color_bars;
};

/// A picture in the making. A view says what stands around its maps, and gets panels to draw in.
class Sheet {
 public:
  /// `annotation` without legend and colour bars, which follow from `keys`.
  Sheet(const ViewRequest& request, int oversampling, Annotation annotation, const LayerKeys& keys,
        const Arrangement& arrangement = {});

  const Palette& palette() const { return palette_; }
  const SheetSize& size() const { return layout_.size; }
  /// `width` of the palette in pixels.
  double Px(double width) const { return width * layout_.size.unit; }
  bool Shows(LayerKind kind) const { return shown_.count(kind) > 0; }

  int num_panels() const { return static_cast<int>(layout_.panels.size()); }
  const Box& frame(int panel) const { return layout_.panels[panel].frame; }
  const FlatCamera& camera(int panel) const { return drafts_[panel].camera; }
  Extent Visible(int panel) const { return VisibleExtent(camera(panel), frame(panel)); }
  /// `length` of the palette in metres of the panel.
  double Meters(int panel, double length) const {
    return Px(length) * drafts_[panel].camera.meters_per_pixel;
  }

  /// Opens a panel. The camera shows `extent`; that of panel 0 shows what the request says instead.
  void Open(int panel, const Extent& extent, const Color& canvas,
            std::vector<std::string> caption = {});

  /// Opens a panel that looks from `side`, without a scale bar: it would be right in one direction
  /// only. `extent` is in the coordinates of its camera.
  void OpenFrom(const SideView& side, int panel, const Extent& extent, const Color& canvas,
                std::vector<std::string> caption);

  /// Opens a panel that shows [0, w] x [0, 1], something that is no map and has no scale bar.
  /// Returns w.
  double OpenChart(int panel, std::vector<std::string> caption);

  /// Adds a part to the caption of an open panel.
  void Say(int panel, const std::string& part) { drafts_[panel].caption.push_back(part); }

  using When = LayerProp::When;

  /// Adds what `draw` returns if the layer is to be shown. Later ones of a kind cover earlier ones.
  template <typename Draw>
  void Add(int panel, LayerKind kind, const Draw& draw, When when = When::kAlways) {
    if (Shows(kind) && !frame(panel).empty()) Put(panel, {draw(), kind, when});
  }

  Scene Finish() const;

 private:
  struct PanelDraft {
    FlatCamera camera;
    Color canvas;
    std::vector<std::string> caption;
    bool is_map = true;
    std::optional<SideView> side;
    std::multimap<LayerKind, LayerProp> layers;  // in the order of drawing
  };

  void Put(int panel, const LayerProp& layer);
  Panel FinishPanel(int panel) const;
  Annotation Complete(Annotation annotation, const LayerKeys& keys) const;

  const ViewRequest& request_;
  const Palette& palette_;
  int oversampling_;
  std::set<LayerKind> shown_;
  Annotation annotation_;
  Layout layout_;
  std::vector<PanelDraft> drafts_;
};

}  // namespace loopscope
