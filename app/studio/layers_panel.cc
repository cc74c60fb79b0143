// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/layers_panel.h"

#include <QHeaderView>
#include <QSlider>

#include <fmt/format.h>

namespace loopscope {
namespace {

enum LayerColumn { kName, kOpacity, kNumColumns };
constexpr int kPercent = 100;

double OpacityOf(const ViewSettings& settings, LayerKind layer) {
  const auto found = settings.opacities.find(layer);
  return found == settings.opacities.end() ? 1.0 : found->second;
}

}  // namespace

LayersPanel::LayersPanel(RunLine run, QWidget* parent) : QTreeWidget(parent), run_(std::move(run)) {
  setColumnCount(kNumColumns);
  setHeaderLabels({"layer", "opacity"});
  setRootIsDecorated(false);
  setFocusPolicy(Qt::NoFocus);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFrameShape(QFrame::NoFrame);
  setColumnWidth(kName, 150);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!is_showing_) run_("layer.toggle " + item->text(kName).toStdString());
  });
}

void LayersPanel::Show(const Session& session) {
  const SessionState& state = session.state();
  const ViewKind view = state.tiles[state.active_tile];
  const auto found = state.views.find(view);
  const ViewSettings settings = found == state.views.end() ? ViewSettings() : found->second;
  const std::set<LayerKind> shown = settings.layers.value_or(DefaultLayersOf(view));

  is_showing_ = true;
  if (view_ != view) {
    view_ = view;
    List(view);
  }
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = topLevelItem(i);
    const LayerKind layer = LayerKindFromName(item->text(kName).toStdString());
    item->setCheckState(kName, shown.count(layer) > 0 ? Qt::Checked : Qt::Unchecked);
    auto* const slider = static_cast<QSlider*>(itemWidget(item, kOpacity));
    if (!slider->isSliderDown()) {
      slider->setValue(static_cast<int>(std::lround(kPercent * OpacityOf(settings, layer))));
    }
  }
  is_showing_ = false;
}

/// The layers of `view`, the uppermost first.
void LayersPanel::List(ViewKind view) {
  clear();
  const std::set<LayerKind>& all = LayersOf(view);
  for (auto layer = all.rbegin(); layer != all.rend(); ++layer) {
    const std::string name = ToString(*layer);
    auto* const item = new QTreeWidgetItem(this, {QString::fromStdString(name)});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    auto* const slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, kPercent);
    slider->setFocusPolicy(Qt::NoFocus);
    slider->setToolTip("How much of what is beneath the layer covers");
    connect(slider, &QSlider::valueChanged, this, [this, name](int value) {
      if (!is_showing_) run_(fmt::format("layer.opacity {} {}", name, value / double{kPercent}));
    });
    setItemWidget(item, kOpacity, slider);
  }
}

}  // namespace loopscope
