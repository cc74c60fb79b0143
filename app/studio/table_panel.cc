// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/table_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "app/session/node_table.h"
#include "app/session/submap_table.h"

namespace loopscope {
namespace {

const char* ExampleOf(TableKind kind) {
  switch (kind) {
    case TableKind::kLoops:
      return "e.g. verdict = closed and residual > 0.2";
    case TableKind::kSubmaps:
      return "e.g. loops > 10";
    case TableKind::kNodes:
      break;
  }
  return "e.g. time 100..200";
}

/// Rows of the table of `kind` that are selected in the session, the main one first.
std::vector<int> RowsSelectedIn(const Session& session, TableKind kind) {
  const SessionState& state = session.state();
  if (kind == TableKind::kNodes && state.node) return {state.node->index};
  if (kind == TableKind::kSubmaps && state.submap) return {state.submap->index};
  if (kind != TableKind::kLoops) return {};
  std::vector<int> rows = state.loops;
  if (const auto main = session.SelectedCandidate()) rows.insert(rows.begin(), *main);
  return rows;
}

}  // namespace

TablePanel::TablePanel(TableKind kind, RunLine run, QWidget* parent)
    : QWidget(parent), kind_(kind), run_(std::move(run)) {
  MakeQueryLine();
  MakeView();
  auto* const line = new QHBoxLayout;
  line->setContentsMargins(6, 4, 6, 4);
  line->setSpacing(8);
  line->addWidget(query_, 1);
  line->addWidget(count_);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(line);
  column->addWidget(view_, 1);
}

void TablePanel::MakeQueryLine() {
  query_ = new QLineEdit(this);
  query_->setPlaceholderText(QString("List only … ") + ExampleOf(kind_));
  query_->setClearButtonEnabled(true);
  count_ = new QLabel(this);
  connect(query_, &QLineEdit::returnPressed, this,
          [this] { run_("table.filter " + ToString(kind_) + " " + query_->text().toStdString()); });
  connect(query_, &QLineEdit::textChanged, this, [this](const QString& text) {
    if (text.isEmpty() && !is_showing_) run_("table.filter " + ToString(kind_));
  });
}

void TablePanel::MakeView() {
  model_ = new TableModel(this);
  view_ = new QTableView(this);
  view_->setModel(model_);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(kind_ == TableKind::kLoops ? QAbstractItemView::ExtendedSelection
                                                     : QAbstractItemView::SingleSelection);
  view_->setAlternatingRowColors(true);
  view_->setShowGrid(false);
  view_->setWordWrap(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(20);
  QHeaderView* const header = view_->horizontalHeader();
  header->setSectionsClickable(true);
  header->setSortIndicatorShown(true);
  header->setSortIndicator(-1, Qt::AscendingOrder);
  header->setHighlightSections(false);
  connect(header, &QHeaderView::sectionClicked, this, [this](int section) {
    const std::string column =
        (kind_ == TableKind::kLoops ? loops_.table() : *table_).columns()[section].name;
    const bool again = listed_ && listed_->sort_by == column && !listed_->descending;
    run_(
        fmt::format("{} {} {}", again ? "table.sort_down" : "table.sort", ToString(kind_), column));
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!is_showing_) RunSelect();
  });
  connect(view_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    RunGo(index.row());
    emit SelectionActivated();
  });
}

/// Rows of the table that are selected in the view, the current one first.
std::vector<int> TablePanel::SelectedRows() const {
  const int current = view_->currentIndex().row();
  std::vector<int> rows;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows()) {
    const bool is_current = index.row() == current;
    rows.insert(is_current ? rows.begin() : rows.end(), model_->TableRow(index.row()));
  }
  return rows;
}

void TablePanel::RunSelect() {
  const std::vector<int> rows = SelectedRows();
  if (rows.empty()) return;
  if (kind_ == TableKind::kLoops) {
    run_(fmt::format("select.loops {}", fmt::join(rows, " ")));
  } else {
    run_(fmt::format("select.{} {}", kind_ == TableKind::kNodes ? "node" : "submap", rows[0]));
  }
}

void TablePanel::RunGo(int shown_row) {
  const int row = model_->TableRow(shown_row);
  const char* const what = kind_ == TableKind::kLoops   ? "loop"
                           : kind_ == TableKind::kNodes ? "node"
                                                        : "submap";
  run_(fmt::format("go.{} {}", what, row));
}

void TablePanel::Forget() {
  is_showing_ = true;
  model_->Show(nullptr, {});
  is_showing_ = false;
  loops_ = LoopTable();
  table_.reset();
  filled_step_.reset();
  filled_steps_ = -1;
  listed_.reset();
}

void TablePanel::Show(const Session& session) {
  if (!session.has_steps() || !isVisible()) return;
  const auto found = session.state().tables.find(kind_);
  const TableSettings settings =
      found == session.state().tables.end() ? TableSettings() : found->second;
  const bool has_new_values =
      filled_step_ != session.state().step || filled_steps_ != session.recording().num_steps();
  is_showing_ = true;
  if (has_new_values) FillTable(session);
  if (has_new_values || !(listed_ == settings)) {
    listed_ = settings;
    List();
  }
  SelectInView(session);
  is_showing_ = false;
}

void TablePanel::FillTable(const Session& session) {
  const Recording& recording = session.recording();
  const MapState& state = session.map();
  filled_step_ = session.state().step;
  filled_steps_ = recording.num_steps();
  if (kind_ == TableKind::kLoops) {
    loops_.Append(recording);
    loops_.Show(recording, state);
  } else if (kind_ == TableKind::kSubmaps) {
    table_ = MakeSubmapTable(recording, state);
  } else {
    table_ = MakeNodeTable(recording, state);
  }
}

void TablePanel::List() {
  const Table& table = kind_ == TableKind::kLoops ? loops_.table() : *table_;
  if (!query_->hasFocus()) query_->setText(QString::fromStdString(listed_->filter));
  try {
    const TableFilter filter(listed_->filter, table.columns());
    std::optional<int> sort_column;
    if (!listed_->sort_by.empty()) sort_column = table.ColumnOf(listed_->sort_by);
    view_->horizontalHeader()->setSortIndicator(
        sort_column.value_or(-1), listed_->descending ? Qt::DescendingOrder : Qt::AscendingOrder);
    const bool is_first = model_->rowCount() == 0;
    model_->Show(&table, RowsOf(table, filter, sort_column, listed_->descending));
    if (is_first && model_->rowCount() > 0) view_->resizeColumnsToContents();
    count_->setText(
        QString::fromStdString(fmt::format("{} of {}", model_->rowCount(), table.num_rows())));
    count_->setStyleSheet("");
  } catch (const std::invalid_argument& error) {
    count_->setText(error.what());
    count_->setStyleSheet("color: #d0372d;");
  }
}

void TablePanel::SelectInView(const Session& session) {
  std::vector<int> rows = RowsSelectedIn(session, kind_);
  const auto is_hidden = [this](int row) { return model_->ShownRow(row) < 0; };
  rows.erase(std::remove_if(rows.begin(), rows.end(), is_hidden), rows.end());
  if (SelectedRows() == rows) return;
  QItemSelection selection;
  for (const int row : rows) {
    const QModelIndex index = model_->index(model_->ShownRow(row), 0);
    selection.select(index, index);
  }
  const QModelIndex main =
      rows.empty() ? QModelIndex() : model_->index(model_->ShownRow(rows.front()), 0);
  QItemSelectionModel* const selected = view_->selectionModel();
  selected->setCurrentIndex(main, QItemSelectionModel::NoUpdate);
  selected->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (main.isValid()) view_->scrollTo(main);
}

}  // namespace loopscope
