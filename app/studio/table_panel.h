// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/session/loop_table.h"
#include "app/session/session.h"
#include "app/session/table_filter.h"
#include "app/studio/run_line.h"
#include "app/studio/table_model.h"

namespace loopscope {

/// One of the tables of the session, with a line for a query above it. A click selects, a double
/// click goes there.
class TablePanel : public QWidget {
  Q_OBJECT

 public:
  TablePanel(TableKind kind, RunLine run, QWidget* parent = nullptr);

  void Show(const Session& session);
  /// To be called when there is another recording.
  void Forget();

  /// Rows that are listed.
  int num_rows() const { return model_->rowCount(); }

 signals:
  void SelectionActivated();

 private:
  void MakeQueryLine();
  void MakeView();
  void FillTable(const Session& session);
  void List();
  void SelectInView(const Session& session);
  void RunSelect();
  void RunGo(int shown_row);
  std::vector<int> SelectedRows() const;

  TableKind kind_;
  RunLine run_;
  QLineEdit* query_ = nullptr;
  QLabel* count_ = nullptr;
  QTableView* view_ = nullptr;
  TableModel* model_ = nullptr;
  LoopTable loops_;                 // for kLoops
  std::optional<Table> table_;      // for the others
  std::optional<int> filled_step_;  // what the table was filled for,
  int filled_steps_ = -1;           // and how far the recording had come
  std::optional<TableSettings> listed_;
  bool is_showing_ = false;
};

}  // namespace loopscope
