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
#include <QLabel>
#include <QPushButton>
#include <stdexcept>

#include "app/session/render_command_line.h"
#include "render/layout.h"

namespace loopscope {
namespace {

constexpr int kUsualFrames = 250;  // of a film, about

QSpinBox* NumberBox(int low, int high, int value, const char* suffix, QWidget* parent) {
  auto* const box = new QSpinBox(parent);
  box->setRange(low, high);
  box->setSuffix(suffix);
  box->setValue(value);
  return box;
}

}  // namespace

ExportDialog::ExportDialog(const ViewRequest& request, const Session& session, QWidget* parent)
    : QDialog(parent),
      request_(request),
      run_(session.path()),
      what_(new QComboBox(this)),
      command_line_(new QPlainTextEdit(this)) {
  setWindowTitle("Export");
  resize(640, 340);
  what_->addItems({"Picture as it is now", "Film of a range of steps"});
  command_line_->setReadOnly(true);
  command_line_->setMaximumHeight(110);
  auto* const form = new QFormLayout(this);
  form->addRow("What", what_);
  form->addRow("Size", MakeSizeRow());
  form->addRow("Steps", MakeStepsRow(session));
  form->addRow("File", MakeFileRow());
  form->addRow("The same without\na display", command_line_);
  form->addRow(MakeButtons());
  ConnectRows();
  ShowKind();
}

QLayout* ExportDialog::MakeSizeRow() {
  width_ = NumberBox(kMinPictureWidth, kMaxPictureSide, request_.width, " px", this);
  height_ = NumberBox(kMinPictureHeight, kMaxPictureSide, request_.height, " px", this);
  auto* const presets = new QComboBox(this);
  presets->addItem("as in the window", QSize(request_.width, request_.height));
  for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)}) {
    presets->addItem(QString("%1 × %2").arg(size.width()).arg(size.height()), size);
  }
  connect(presets, QOverload<int>::of(&QComboBox::activated), this, [this, presets](int i) {
    width_->setValue(presets->itemData(i).toSize().width());
    height_->setValue(presets->itemData(i).toSize().height());
  });
  auto* const row = new QHBoxLayout;
  for (QWidget* const part : {static_cast<QWidget*>(presets), static_cast<QWidget*>(width_),
                              static_cast<QWidget*>(height_)}) {
    row->addWidget(part);
  }
  row->addStretch();
  return row;
}

QWidget* ExportDialog::MakeStepsRow(const Session& session) {
  const int last = session.last_step();
  first_ = NumberBox(0, last, 0, "", this);
  last_ = NumberBox(0, last, last, "", this);
  stride_ = NumberBox(1, std::max(1, last), std::max(1, last / kUsualFrames), "", this);
  frames_per_second_ = NumberBox(1, 120, 25, " frames/s", this);
  steps_ = new QWidget(this);
  steps_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* const row = new QHBoxLayout(steps_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(first_);
  row->addWidget(new QLabel("to"));
  row->addWidget(last_);
  row->addWidget(new QLabel("every"));
  row->addWidget(stride_);
  row->addWidget(frames_per_second_);
  row->addStretch();
  return steps_;
}

QLayout* ExportDialog::MakeFileRow() {
  path_ = new QLineEdit(this);
  path_->setObjectName("path");
  auto* const browse = new QPushButton("Choose…", this);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::ChoosePath);
  auto* const row = new QHBoxLayout;
  row->addWidget(path_, 1);
  row->addWidget(browse);
  return row;
}

QWidget* ExportDialog::MakeButtons() {
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton("Export", QDialogButtonBox::AcceptRole);
  QPushButton* const copy = buttons->addButton("Copy command", QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(command_line_->toPlainText()); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return buttons;
}

void ExportDialog::ConnectRows() {
  connect(what_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ExportDialog::ShowKind);
  connect(path_, &QLineEdit::textChanged, this, &ExportDialog::ShowCommandLine);
  for (QSpinBox* const box : {width_, height_, first_, last_, stride_, frames_per_second_}) {
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &ExportDialog::ShowCommandLine);
  }
  connect(first_, QOverload<int>::of(&QSpinBox::valueChanged), last_, &QSpinBox::setMinimum);
}

std::vector<std::string> ExportDialog::arguments() const {
  const std::string path = path_->text().toStdString();
  if (!is_film()) return RenderArguments(run_, RequestOfSize(), path);
  const FilmSteps steps{first_->value(), last_->value(), stride_->value(),
                        static_cast<double>(frames_per_second_->value())};
  return FilmArguments(run_, RequestOfSize(), steps, path);
}

ViewRequest ExportDialog::RequestOfSize() const {
  ViewRequest request = request_;
  request.width = width_->value();
  request.height = height_->value();
  const bool has_size_of_window =
      request.width == request_.width && request.height == request_.height;
  if (has_size_of_window) return request;
  request.text_height.reset();
  request.plain = false;
  return request;
}

QString ExportDialog::DefaultPath() const {
  const QFileInfo run(QString::fromStdString(run_));
  const QString start = QString("%1/%2.%3")
                            .arg(run.absolutePath(), run.completeBaseName(),
                                 QString::fromStdString(ToString(request_.view)));
  return is_film() ? start + ".mp4"
                   : QString("%1.%2.png").arg(start).arg(request_.step.value_or(0));
}

void ExportDialog::ChoosePath() {
  const QString path = QFileDialog::getSaveFileName(
      this, "Export", path_->text(),
      is_film() ? "Videos (*.mp4 *.avi)" : "Pictures (*.png *.svg *.pdf)");
  if (!path.isEmpty()) path_->setText(path);
}

void ExportDialog::ShowKind() {
  steps_->setEnabled(is_film());
  path_->setText(DefaultPath());
  ShowCommandLine();
}

void ExportDialog::ShowCommandLine() {
  try {
    command_line_->setPlainText(QString::fromStdString(CommandLine(arguments())));
  } catch (const std::invalid_argument& error) {
    command_line_->setPlainText(error.what());
  }
}

}  // namespace loopscope
