// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/options_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>
#include <exception>

#include "app/session/option_rows.h"
#include "core/io/options_file.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

enum OptionColumn { kKey, kValue, kUnit, kDefault, kSentence, kNumColumns };

}  // namespace

OptionsDialog::OptionsDialog(const Options& options, QWidget* parent)
    : QDialog(parent),
      options_(options),
      search_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)),
      message_(new QLabel(this)) {
  setWindowTitle("Map again with other options");
  resize(1040, 640);
  search_->setPlaceholderText("Find an option");
  search_->setClearButtonEnabled(true);
  message_->setText(
      "Double click a value to change it. The map becomes a new recording; this one "
      "stays.");
  message_->setWordWrap(true);
  tree_->setColumnCount(kNumColumns);
  tree_->setHeaderLabels({"Option", "Value", "Unit", "Default", "What it does"});
  tree_->setRootIsDecorated(false);
  tree_->setAlternatingRowColors(true);
  tree_->setUniformRowHeights(true);
  auto* const buttons = new QDialogButtonBox(this);
  QPushButton* const file = buttons->addButton("From a file…", QDialogButtonBox::ActionRole);
  QPushButton* const defaults = buttons->addButton("Defaults", QDialogButtonBox::ResetRole);
  buttons->addButton("Map again", QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  auto* const column = new QVBoxLayout(this);
  for (QWidget* const part : {static_cast<QWidget*>(search_), static_cast<QWidget*>(tree_),
                              static_cast<QWidget*>(message_), static_cast<QWidget*>(buttons)}) {
    column->addWidget(part);
  }
  connect(search_, &QLineEdit::textChanged, this, &OptionsDialog::Filter);
  connect(tree_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item, int) { tree_->editItem(item, kValue); });
  connect(tree_, &QTreeWidget::itemChanged, this, &OptionsDialog::Edit);
  connect(file, &QPushButton::clicked, this, &OptionsDialog::ReadFromFile);
  connect(defaults, &QPushButton::clicked, this, [this] {
    options_ = LoopscopePreset();
    Fill();
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  Fill();
}

void OptionsDialog::Fill() {
  is_filling_ = true;
  tree_->clear();
  for (const OptionEntry& entry : OptionRows(options_, LoopscopePreset())) {
    auto* const item = new QTreeWidgetItem(
        tree_, {QString::fromStdString(entry.key), QString::fromStdString(entry.value),
                QString::fromStdString(entry.unit), QString::fromStdString(entry.preset_value),
                QString::fromStdString(entry.sentence)});
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(kValue, QString::fromStdString("expected: " + entry.expected));
    item->setToolTip(kSentence, item->text(kSentence));
    QFont font = item->font(kValue);
    font.setBold(entry.changed);
    item->setFont(kKey, font);
    item->setFont(kValue, font);
  }
  for (const int column : {kKey, kValue, kUnit, kDefault}) tree_->resizeColumnToContents(column);
  is_filling_ = false;
  Filter(search_->text());
}

void OptionsDialog::Filter(const QString& text) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = tree_->topLevelItem(i);
    const bool fits = item->text(kKey).contains(text, Qt::CaseInsensitive) ||
                      item->text(kSentence).contains(text, Qt::CaseInsensitive);
    item->setHidden(!fits);
  }
}

/// Takes over what was typed; if it makes no sense, says so and goes back.
void OptionsDialog::Edit(QTreeWidgetItem* item) {
  if (is_filling_) return;
  try {
    SetFromText(item->text(kKey).toStdString(), item->text(kValue).toStdString(), &options_);
    message_->setText("");
  } catch (const OptionError& error) {
    message_->setText(error.what());
  }
  const int scrolled = tree_->indexOfTopLevelItem(item);
  // The item must not be deleted while the view still closes its editor.
  QMetaObject::invokeMethod(
      this,
      [this, scrolled] {
        Fill();
        tree_->setCurrentItem(tree_->topLevelItem(scrolled));
      },
      Qt::QueuedConnection);
}

void OptionsDialog::ReadFromFile() {
  const QString path = QFileDialog::getOpenFileName(
      this, "Options", QString(), "Cartographer's Lua or key = value (*.lua *.txt);;All files (*)");
  if (path.isEmpty()) return;
  try {
    const OptionsFile file = ReadOptionsFile(path.toStdString());
    options_ = file.options;
    QString notes;
    for (const std::string& note : file.notes) notes += QString::fromStdString(note) + "\n";
    message_->setText(notes.trimmed());
  } catch (const std::exception& error) {
    message_->setText(error.what());
  }
  Fill();
}

}  // namespace loopscope
