// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "app/session/table.h"

namespace loopscope {

/// Some rows of a table for Qt's views.
class TableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// Shows `rows` of `table`, which has to live until the next call.
  void Show(const Table* table, std::vector<int> rows);

  /// Row of the table that is shown in row `shown`.
  int TableRow(int shown) const { return rows_[shown]; }
  /// Where a row of the table is shown; -1 if it is not.
  int ShownRow(int table_row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const Table* table_ = nullptr;
  std::vector<int> rows_;
};

}  // namespace loopscope
