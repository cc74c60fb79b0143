// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/inspector_panel.h"

#include <QHeaderView>
#include <QStyledItemDelegate>

#include "app/studio/theme.h"

namespace loopscope {
namespace {

enum InspectorColumn { kName, kValue, kNumColumns };

/// Rows as high as their texts, which are wrapped, are in the columns as wide as they are now.
class WrappedRows : public QStyledItemDelegate {
 public:
  explicit WrappedRows(QTreeView* view) : QStyledItemDelegate(view), view_(view) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int kAround = 14, kBetween = 6;  // [px]
    const bool is_title = !index.parent().isValid();
    const int indent = index.column() == kName ? view_->indentation() : 0;
    const int width = is_title ? view_->viewport()->width() : view_->columnWidth(index.column());
    QStyleOptionViewItem styled = option;
    initStyleOption(&styled, index);
    const QRect text = QFontMetrics(styled.font)
                           .boundingRect(0, 0, std::max(40, width - indent - kAround), 10000,
                                         Qt::TextWordWrap, styled.text);
    return {text.width() + kAround, text.height() + kBetween};
  }

 private:
  QTreeView* view_;
};

QString ValueOf(const ReportRow& row) {
  const QString value = QString::fromStdString(row.value);
  return row.expected.empty() ? value
                              : value + "\nexpected: " + QString::fromStdString(row.expected);
}

QTreeWidgetItem* MakeTitle(const Section& section) {
  auto* const title = new QTreeWidgetItem({QString::fromStdString(section.title)});
  QFont bold = title->font(kName);
  bold.setBold(true);
  title->setFont(kName, bold);
  return title;
}

QTreeWidgetItem* MakeRow(const ReportRow& row) {
  const QString name = QString::fromStdString(row.name);
  QString last_part = name.contains(' ') ? name : name.section('.', -1);  // of an option
  last_part.replace("_", QString("_") + QChar(0x200b));                   // may be wrapped there
  auto* const item = new QTreeWidgetItem({last_part, ValueOf(row)});
  item->setToolTip(kName, name);
  item->setToolTip(kValue,
                   row.exact.empty() ? item->text(kValue) : QString::fromStdString(row.exact));
  for (const int column : {kName, kValue}) item->setTextAlignment(column, Qt::AlignTop);
  if (!row.passed) item->setForeground(kValue, QColor(0xe0483e));
  if (row.passed && !row.expected.empty()) item->setForeground(kValue, QColor(0x2f9e4f));
  return item;
}

}  // namespace

InspectorPanel::InspectorPanel(SceneWorker* worker, QWidget* parent)
    : QTreeWidget(parent), worker_(worker) {
  setColumnCount(kNumColumns);
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(8);
  setFrameShape(QFrame::NoFrame);
  setWordWrap(true);
  setFocusPolicy(Qt::NoFocus);
  setSelectionMode(QAbstractItemView::NoSelection);
  setItemDelegate(new WrappedRows(this));
  setColumnWidth(kName, 140);
  connect(header(), &QHeaderView::sectionResized, this, [this] { scheduleDelayedItemsLayout(); });
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
    QTreeWidgetItem* const title = MakeTitle(section);
    addTopLevelItem(title);
    title->setFirstColumnSpanned(true);
    for (const ReportRow& row : section.rows) title->addChild(MakeRow(row));
  }
  expandAll();
}

}  // namespace loopscope
