// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/table_model.h"

#include <algorithm>
#include <utility>

namespace loopscope {

void TableModel::Show(const Table* table, std::vector<int> rows) {
  const bool same_shape = table == table_ && rows == rows_;
  if (!same_shape) beginResetModel();
  table_ = table;
  rows_ = std::move(rows);
  if (!same_shape) {
    endResetModel();
  } else if (!rows_.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  }
}

int TableModel::ShownRow(int table_row) const {
  const auto found = std::find(rows_.begin(), rows_.end(), table_row);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int TableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || table_ == nullptr ? 0 : table_->num_columns();
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
  const Column& column = table_->columns()[index.column()];
  if (role == Qt::DisplayRole) {
    return QString::fromStdString(table_->Text(rows_[index.row()], index.column()));
  }
  if (role == Qt::TextAlignmentRole && column.kind == Column::Kind::kNumber) {
    return int(Qt::AlignRight | Qt::AlignVCenter);
  }
  return {};
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (table_ == nullptr || orientation != Qt::Horizontal) return {};
  const Column& column = table_->columns()[section];
  if (role == Qt::ToolTipRole) return QString::fromStdString(column.help);
  if (role != Qt::DisplayRole) return {};
  QString name = QString::fromStdString(column.name).replace('_', ' ');
  if (!column.unit.empty()) name += " [" + QString::fromStdString(column.unit) + "]";
  return name;
}

}  // namespace loopscope
