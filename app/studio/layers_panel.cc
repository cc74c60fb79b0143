// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/layers_panel.h"

#include <QHeaderView>

namespace loopscope {

LayersPanel::LayersPanel(RunLine run, QWidget* parent)
    : QTreeWidget(parent), run_(std::move(run)) {
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::NoFrame);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!is_showing_) run_("layer.toggle " + item->text(0).toStdString());
  });
}

void LayersPanel::Show(const Session& session) {
  const SessionState& state = session.state();
  const ViewKind view = state.tiles[state.active_tile];
  const auto settings = state.views.find(view);
  std::set<LayerKind> shown = DefaultLayersOf(view);
  if (settings != state.views.end()) shown = settings->second.layers.value_or(shown);

  is_showing_ = true;
  if (view_ != view) {
    view_ = view;
    clear();
    const std::set<LayerKind>& all = LayersOf(view);
    for (auto layer = all.rbegin(); layer != all.rend(); ++layer) {
      auto* const item = new QTreeWidgetItem(this, {QString::fromStdString(ToString(*layer))});
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    }
  }
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = topLevelItem(i);
    const bool is_shown = shown.count(LayerKindFromName(item->text(0).toStdString())) > 0;
    item->setCheckState(0, is_shown ? Qt::Checked : Qt::Unchecked);
  }
  is_showing_ = false;
}

}  // namespace loopscope
