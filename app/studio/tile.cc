// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/tile.h"

#include <QHBoxLayout>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>

#include <fmt/format.h>

#include "app/session/commands.h"
#include "render/layout.h"
#include "render/number_text.h"

namespace loopscope {
namespace {

// The commands that show the views, in the order of the list.
const std::vector<ViewKind> kKinds{ViewKind::kMap,   ViewKind::kSubmap, ViewKind::kUpdate,
                                   ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph,
                                   ViewKind::kTime,  ViewKind::kChart};

const std::vector<ChartKind> kCharts{ChartKind::kScores, ChartKind::kScoreHistogram,
                                     ChartKind::kResiduals, ChartKind::kResidualHistogram,
                                     ChartKind::kCosts};

/// "Score histogram"
QString TitleOf(ChartKind kind) {
  const QString name = QString::fromStdString(ToString(kind)).replace('-', ' ');
  return name.left(1).toUpper() + name.mid(1);
}

template <typename Kind>
int PlaceOf(Kind kind, const std::vector<Kind>& kinds) {
  return static_cast<int>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

constexpr int kTextHeight = 12;       // [px] as in the rest of the window
constexpr int kSmallTextHeight = 11;  // [px] in a small tile,
constexpr int kSmallWidth = 560;      // [px] which has no room for a legend either

}  // namespace

Tile::Tile(int index, SceneWorker* worker, RunLine run, QWidget* parent)
    : QWidget(parent), index_(index), worker_(worker), run_(std::move(run)) {
  MakeLists();
  MakeSearchBar();
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  view_ = new ViewWidget(this);
  Arrange();
  ConnectView();
}

void Tile::MakeLists() {
  kinds_ = new QComboBox(this);
  for (const ViewKind kind : kKinds) {
    const Command& command = CommandNamed("view." + ToString(kind));
    kinds_->addItem(QString::fromStdString(command.title));
  }
  charts_ = new QComboBox(this);
  for (const ChartKind kind : kCharts) charts_->addItem(TitleOf(kind));
  for (QComboBox* const list : {kinds_, charts_}) list->setFocusPolicy(Qt::NoFocus);
  connect(kinds_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    Activate();
    run_("view." + ToString(kKinds[i]));
  });
  connect(charts_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    Activate();
    run_("chart.kind " + ToString(kCharts[i]));
  });
}

void Tile::MakeSearchBar() {
  search_ = new SearchBar(
      [this](const std::string& line) {
        Activate();
        run_(line);
      },
      this);
}

void Tile::Arrange() {
  auto* const bar = new QHBoxLayout;
  bar->setContentsMargins(6, 2, 6, 2);
  bar->setSpacing(12);
  bar->addWidget(kinds_);
  bar->addWidget(charts_);
  bar->addWidget(message_, 1);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(bar);
  column->addWidget(search_);
  column->addWidget(view_, 1);
}

void Tile::ConnectView() {
  connect(view_, &ViewWidget::CameraRested, this, [this](double x, double y, double width) {
    Activate();
    run_(fmt::format("camera.set {} {} {}", x, y, width));
  });
  connect(view_, &ViewWidget::Clicked, this, &Tile::Select);
  connect(view_, &ViewWidget::DoubleClicked, this, &Tile::GoTo);
  connect(view_, &ViewWidget::Hovered, this, &Tile::Hover);
  connect(view_, &ViewWidget::Left, this, [this] { emit Pointed(""); });
}

void Tile::Activate() { run_("tile.select " + std::to_string(index_)); }

void Tile::ShowLists(const Session& session) {
  const SessionState& state = session.state();
  const ViewKind kind = state.tiles[index_];
  kinds_->setCurrentIndex(PlaceOf(kind, kKinds));
  charts_->setVisible(kind == ViewKind::kChart);
  charts_->setCurrentIndex(PlaceOf(state.chart, kCharts));
  QFont font = kinds_->font();
  font.setBold(state.active_tile == index_ && state.tiles.size() > 1);
  kinds_->setFont(font);
}

void Tile::Show(const Session& session) {
  ShowLists(session);
  search_->setVisible(session.state().tiles[index_] == ViewKind::kSearch);
  search_->Show(search_size_, session.state().search);
  if (!session.has_steps() || !isVisible()) return;
  ViewRequest request = session.RequestOf(index_);
  request.width = std::max(kMinPictureWidth, view_->width());
  request.height = std::max(kMinPictureHeight, view_->height());
  const bool is_small = view_->width() < kSmallWidth;
  request.text_height = is_small ? kSmallTextHeight : kTextHeight;
  request.plain = is_small;
  if (asked_ == request) return;
  asked_ = request;
  worker_->Ask(index_, request, view_->device_pixels());
}

bool Tile::IsOfOtherSize(const ViewRequest& request) const {
  return asked_ && (asked_->width != request.width || asked_->height != request.height);
}

void Tile::TakeScene() {
  std::optional<DrawnScene> drawn = worker_->Take(index_);
  if (!drawn || IsOfOtherSize(drawn->request)) return;
  message_->setText(QString::fromStdString(drawn->error));
  search_size_ = drawn->search.value_or(SearchSize());
  search_->Show(search_size_, drawn->request.search);
  if (!drawn->scene) {
    view_->Clear();
    shown_.reset();
    inspector_.reset();
    return;
  }
  const bool same_view = shown_ && shown_->view == drawn->request.view;
  shown_ = drawn->request;
  inspector_ = std::move(drawn->inspector);
  view_->Show(std::move(*drawn->scene), same_view);
}

void Tile::Forget() {
  asked_.reset();
  shown_.reset();
  inspector_.reset();
}

std::optional<Finding> Tile::FindAt(const QPoint& position) const {
  constexpr double kReach = 6.0;  // [px]
  const auto place = view_->PlaceAt(position);
  if (!place || !inspector_) return std::nullopt;
  return inspector_->WhatIsAt(place->panel, place->point, kReach * place->meters_per_pixel);
}

void Tile::Hover(const QPoint& position) {
  const auto place = view_->PlaceAt(position);
  const std::string text = place && place->is_map ? FixedText(place->point.x(), 2) + " m, " +
                                                        FixedText(place->point.y(), 2) + " m"
                                                  : "";
  emit Pointed(QString::fromStdString(text));
  const std::optional<Finding> finding = FindAt(position);
  if (!finding || finding->facts.empty()) {
    QToolTip::hideText();
    return;
  }
  QString rows;
  for (const Fact& fact : finding->facts) {
    rows += QString("<tr><td>%1&nbsp;&nbsp;</td><td align=right><b>%2</b></td></tr>")
                .arg(QString::fromStdString(fact.name).toHtmlEscaped(),
                     QString::fromStdString(fact.value).toHtmlEscaped());
  }
  QToolTip::showText(view_->mapToGlobal(position), "<table>" + rows + "</table>", view_);
}

void Tile::Select(const QPoint& position) {
  Activate();
  const std::optional<Finding> finding = FindAt(position);
  if (!finding || !shown_) return;
  if (finding->loop) {
    run_(fmt::format("select.loops {}", *finding->loop));
  } else if (finding->range) {
    run_(fmt::format("table.filter loops {} {:.4g}..{:.4g}", finding->range->quantity,
                     finding->range->begin, finding->range->end));
    emit Listed();
  }
  const bool is_of_map = shown_->view == ViewKind::kMap || shown_->view == ViewKind::kGraph ||
                         shown_->view == ViewKind::kSubmap;
  if (!is_of_map) return;
  if (finding->node && finding->submap && shown_->view != ViewKind::kSubmap) {
    run_(fmt::format("select.pair {} {}", finding->node->index, finding->submap->index));
  } else if (finding->node) {
    run_(fmt::format("select.node {}", finding->node->index));
  } else if (finding->submap) {
    run_(fmt::format("select.submap {}", finding->submap->index));
  }
}

void Tile::GoTo(const QPoint& position) {
  Activate();
  const std::optional<Finding> finding = FindAt(position);
  if (finding && finding->loop) {
    run_(fmt::format("go.loop {}", *finding->loop));
  } else if (finding && finding->step) {
    run_(fmt::format("step.seek {}", *finding->step));
  } else {
    run_("camera.fit");
  }
}

}  // namespace loopscope
