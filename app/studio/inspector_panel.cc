// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/inspector_panel.h"

#include <QHeaderView>

#include "app/studio/theme.h"

namespace loopscope {
namespace {

enum InspectorColumn { kName, kValue, kExpected, kNumColumns };

}  // namespace

InspectorPanel::InspectorPanel(SceneWorker* worker, QWidget* parent)
    : QTreeWidget(parent), worker_(worker) {
  setColumnCount(kNumColumns);
  setHeaderLabels({"", "value", "expected"});
  setRootIsDecorated(false);
  setIndentation(8);
  setFrameShape(QFrame::NoFrame);
  setWordWrap(true);
  setFocusPolicy(Qt::NoFocus);
  setColumnWidth(kName, 130);
  setColumnWidth(kValue, 170);
  setTextElideMode(Qt::ElideRight);
  connect(worker_, &SceneWorker::Reported, this, &InspectorPanel::TakeReport);
}

void InspectorPanel::Show(const Session& session) {
  if (!session.has_steps() || !isVisible()) return;
  const SessionState& state = session.state();
  const ReportSubject subject{state.step, state.node, state.submap};
  if (asked_ == subject) return;
  asked_ = subject;
  worker_->AskReport(subject);
}

void InspectorPanel::TakeReport() {
  const std::optional<InspectionReport> report = worker_->TakeReport();
  if (!report) return;
  clear();
  for (const Section& section : *report) {
    auto* const title = new QTreeWidgetItem(this, {QString::fromStdString(section.title)});
    QFont bold = title->font(kName);
    bold.setBold(true);
    title->setFont(kName, bold);
    title->setFirstColumnSpanned(true);
    for (const ReportRow& row : section.rows) {
      const QString name = QString::fromStdString(row.name);
      auto* const item = new QTreeWidgetItem(
          title, {name.section('.', -1), QString::fromStdString(row.value),
                  QString::fromStdString(row.expected)});
      item->setToolTip(kName, name);
      item->setToolTip(kValue, item->text(kValue));
      item->setToolTip(kExpected, item->text(kExpected));
      if (!row.passed) item->setForeground(kValue, QColor(0xe0483e));
      if (row.passed && !row.expected.empty()) item->setForeground(kValue, QColor(0x2f9e4f));
    }
  }
  expandAll();
}

}  // namespace loopscope
