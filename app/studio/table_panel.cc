// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/table_panel.h"

#include <stdexcept>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QVBoxLayout>
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

}  // namespace

TablePanel::TablePanel(TableKind kind, RunLine run, QWidget* parent)
    : QWidget(parent), kind_(kind), run_(std::move(run)) {
  MakeQueryLine();
  MakeView();
  auto* const line = new QHBoxLayout;
  line->setContentsMargins(6, 4, 6, 4);
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
  connect(query_, &QLineEdit::returnPressed, this, [this] {
    run_("table.filter " + ToString(kind_) + " " + query_->text().toStdString());
  });
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
    run_(fmt::format("{} {} {}", again ? "table.sort_down" : "table.sort", ToString(kind_),
                     column));
  });
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (!is_showing_ && current.isValid()) RunSelection("select", current.row());
          });
  connect(view_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    RunSelection("go", index.row());
    emit SelectionActivated();
  });
}

/// "select" or "go": the command for a row that is shown.
void TablePanel::RunSelection(const char* what, int shown_row) {
  const int row = model_->TableRow(shown_row);
  if (kind_ == TableKind::kLoops) {
    run_(fmt::format("{}.loop {}", what, row));
  } else {
    run_(fmt::format("{}.{} {}", what, kind_ == TableKind::kNodes ? "node" : "submap", row));
  }
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
  const bool has_new_values = filled_step_ != session.state().step ||
                              filled_steps_ != session.recording().num_steps();
  is_showing_ = true;
  if (has_new_values) FillTable(session);
  if (has_new_values || !(listed_ == settings)) {
    listed_ = settings;
    List(session);
  }
  SelectInView(session);
  is_showing_ = false;
}

void TablePanel::FillTable(const Session& session) {
  const Recording& recording = session.recording();
  const MapState state = StateAfterStep(recording, session.state().step);
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

void TablePanel::List(const Session&) {
  const Table& table = kind_ == TableKind::kLoops ? loops_.table() : *table_;
  if (!query_->hasFocus()) query_->setText(QString::fromStdString(listed_->filter));
  try {
    const TableFilter filter(listed_->filter, table.columns());
    std::optional<int> sort_column;
    if (!listed_->sort_by.empty()) sort_column = table.ColumnOf(listed_->sort_by);
    view_->horizontalHeader()->setSortIndicator(
        sort_column.value_or(-1), listed_->descending ? Qt::DescendingOrder : Qt::AscendingOrder);
    const bool is_first = model_->columnCount() == 0;
    model_->Show(&table, RowsOf(table, filter, sort_column, listed_->descending));
    if (is_first) view_->resizeColumnsToContents();
    count_->setText(QString::fromStdString(
        fmt::format("{} of {}", model_->rowCount(), table.num_rows())));
    count_->setStyleSheet("");
  } catch (const std::invalid_argument& error) {
    count_->setText(error.what());
    count_->setStyleSheet("color: #d0372d;");
  }
}

/// The row of what is selected in the session.
void TablePanel::SelectInView(const Session& session) {
  const SessionState& state = session.state();
  int table_row = -1;
  if (kind_ == TableKind::kNodes && state.node) table_row = state.node->index;
  if (kind_ == TableKind::kSubmaps && state.submap) table_row = state.submap->index;
  if (kind_ == TableKind::kLoops) table_row = session.SelectedCandidate().value_or(-1);
  const QModelIndex current = view_->currentIndex();
  if (current.isValid() && model_->TableRow(current.row()) == table_row) return;
  const int shown = table_row < 0 ? -1 : model_->ShownRow(table_row);
  if (shown < 0) {
    view_->clearSelection();
    view_->setCurrentIndex({});
    return;
  }
  view_->setCurrentIndex(model_->index(shown, 0));
  view_->selectRow(shown);
}

}  // namespace loopscope
