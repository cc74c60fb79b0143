// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/export_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include "app/session/render_command_line.h"
#include "render/layout.h"

namespace loopscope {
namespace {

QSpinBox* PixelBox(int low, int value, QWidget* parent) {
  auto* const box = new QSpinBox(parent);
  box->setRange(low, kMaxPictureSide);
  box->setSuffix(" px");
  box->setValue(value);
  return box;
}

}  // namespace

ExportDialog::ExportDialog(const ViewRequest& request, std::string run, QWidget* parent)
    : QDialog(parent),
      request_(request),
      run_(std::move(run)),
      width_(PixelBox(kMinPictureWidth, request.width, this)),
      height_(PixelBox(kMinPictureHeight, request.height, this)),
      path_(new QLineEdit(DefaultPath(), this)),
      command_line_(new QPlainTextEdit(this)) {
  setWindowTitle("Export the picture");
  resize(620, 300);
  command_line_->setReadOnly(true);
  command_line_->setMaximumHeight(90);

  auto* const presets = new QComboBox(this);
  presets->addItem("as in the window", QSize(request.width, request.height));
  for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)}) {
    presets->addItem(QString("%1 × %2").arg(size.width()).arg(size.height()), size);
  }
  connect(presets, QOverload<int>::of(&QComboBox::activated), this, [this, presets](int i) {
    width_->setValue(presets->itemData(i).toSize().width());
    height_->setValue(presets->itemData(i).toSize().height());
  });
  auto* const size = new QHBoxLayout;
  size->addWidget(presets);
  size->addWidget(width_);
  size->addWidget(height_);
  size->addStretch();

  auto* const browse = new QPushButton("Choose…", this);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::ChoosePath);
  auto* const file = new QHBoxLayout;
  file->addWidget(path_, 1);
  file->addWidget(browse);

  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton("Export", QDialogButtonBox::AcceptRole);
  QPushButton* const copy = buttons->addButton("Copy command", QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(command_line_->toPlainText()); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* const form = new QFormLayout(this);
  form->addRow("Size", size);
  form->addRow("File", file);
  form->addRow("The same without\na display", command_line_);
  form->addRow(buttons);
  connect(path_, &QLineEdit::textChanged, this, &ExportDialog::ShowCommandLine);
  for (QSpinBox* const box : {width_, height_}) {
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &ExportDialog::ShowCommandLine);
  }
  ShowCommandLine();
}

ViewRequest ExportDialog::request() const {
  ViewRequest request = request_;
  request.width = width_->value();
  request.height = height_->value();
  const bool has_size_of_window =
      request.width == request_.width && request.height == request_.height;
  if (!has_size_of_window) request.text_height.reset();
  return request;
}

QString ExportDialog::DefaultPath() const {
  const QFileInfo run(QString::fromStdString(run_));
  return QString("%1/%2.%3.%4.png")
      .arg(run.absolutePath(), run.completeBaseName(),
           QString::fromStdString(ToString(request_.view)))
      .arg(request_.step.value_or(0));
}

void ExportDialog::ChoosePath() {
  const QString path = QFileDialog::getSaveFileName(this, "Picture", path_->text(),
                                                    "Pictures (*.png *.svg *.pdf)");
  if (!path.isEmpty()) path_->setText(path);
}

void ExportDialog::ShowCommandLine() {
  command_line_->setPlainText(QString::fromStdString(
      RenderCommandLine(run_, request(), path_->text().toStdString())));
}

}  // namespace loopscope
