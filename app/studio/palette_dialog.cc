// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/palette_dialog.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/session/commands.h"
#include "app/studio/theme.h"

namespace loopscope {
namespace {

QString KeysOf(const Command& command) {
  QStringList keys;
  for (const std::string& key : command.keys) keys.append(QString::fromStdString(key));
  return keys.join(", ");
}

QString TitleOf(const Command& command) {
  QString title = QString::fromStdString(command.title);
  if (!command.argument.empty()) {
    title += QString::fromStdString("   ·   " + command.name + " " + command.argument);
  }
  const QString keys = KeysOf(command);
  return keys.isEmpty() ? title : title + "   ·   " + keys;
}

}  // namespace

PaletteDialog::PaletteDialog(const Session& session, RunLine run, QWidget* parent)
    : QDialog(parent, Qt::Popup),
      session_(session),
      run_(std::move(run)),
      text_(new QLineEdit(this)),
      list_(new QListWidget(this)) {
  text_->setPlaceholderText("What do you want to do?");
  text_->installEventFilter(this);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setIconSize({16, 16});
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->addWidget(text_);
  column->addWidget(list_);
  resize(560, 380);
  move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 80)));
  connect(text_, &QLineEdit::textChanged, this, &PaletteDialog::Fill);
  connect(text_, &QLineEdit::returnPressed, this, &PaletteDialog::RunChosen);
  connect(list_, &QListWidget::itemClicked, this, &PaletteDialog::RunChosen);
  Fill();
  text_->setFocus();
}

bool PaletteDialog::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
      const int row = list_->currentRow() + (key == Qt::Key_Down ? 1 : -1);
      list_->setCurrentRow(std::clamp(row, 0, std::max(0, list_->count() - 1)));
      return true;
    }
  }
  return QDialog::eventFilter(object, event);
}

/// Lists what fits. A command that needs an argument fits by its name with the argument behind it.
void PaletteDialog::Fill() {
  const std::string text = text_->text().toStdString();
  const std::string first_word = text.substr(0, text.find(' '));
  list_->clear();
  for (const Command& command : Commands()) {
    const bool fits = MatchesPalette(command, text) || command.name == first_word;
    if (!fits || !command.is_possible(session_)) continue;
    auto* const item = new QListWidgetItem(IconOf(command.name), TitleOf(command), list_);
    item->setData(Qt::UserRole, QString::fromStdString(command.name));
  }
  list_->setCurrentRow(0);
}

void PaletteDialog::RunChosen() {
  const QListWidgetItem* const item = list_->currentItem();
  if (item == nullptr) return;
  const std::string name = item->data(Qt::UserRole).toString().toStdString();
  const std::string text = text_->text().toStdString();
  const Command& command = CommandNamed(name);
  const bool is_typed = text.rfind(name + " ", 0) == 0;
  if (!command.argument.empty() && command.menu.empty() && !is_typed) {
    text_->setText(QString::fromStdString(name + " "));
    return;
  }
  const RunLine run = run_;
  close();
  run(is_typed ? text : name);
}

KeysDialog::KeysDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle("Keys");
  auto* const sheet = new QWidget;
  auto* const grid = new QGridLayout(sheet);
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(4);
  std::string menu;
  int row = 0, column = 0;
  for (const Command& command : Commands()) {
    if (command.keys.empty()) continue;
    if (command.menu != menu) {
      menu = command.menu;
      if (menu == "View") {  // so that both columns are about as long
        column = 2;
        row = 0;
      }
      grid->addWidget(new QLabel("<b>" + QString::fromStdString(menu) + "</b>"), row++, column);
    }
    grid->addWidget(new QLabel(QString::fromStdString(command.title)), row, column);
    grid->addWidget(new QLabel(KeysOf(command)), row++, column + 1);
  }
  grid->addWidget(new QLabel("<b>Mouse</b>"), row++, column);
  for (const auto& [what, how] :
       {std::pair("Zoom at the pointer", "wheel"), std::pair("Move the map", "drag"),
        std::pair("Select what is under the pointer", "click"),
        std::pair("Show all", "double click")}) {
    grid->addWidget(new QLabel(what), row, column);
    grid->addWidget(new QLabel(how), row++, column + 1);
  }
  grid->setRowStretch(grid->rowCount(), 1);
  auto* const area = new QScrollArea(this);
  area->setWidget(sheet);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(area);
  resize(820, 620);
}

}  // namespace loopscope
