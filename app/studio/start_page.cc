// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/start_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopscope {

StartPage::StartPage(const RunLine& run, QWidget* parent) : QWidget(parent) {
  auto* const title = new QLabel(
      "<h2>Why did that loop close, or not?</h2>"
      "<p>Open a scan log to map it, or a recording of a run.<br>"
      "You can also drop a file onto this window.</p>");
  title->setAlignment(Qt::AlignCenter);
  auto* const open = new QPushButton("Open a log or recording…");
  auto* const demo = new QPushButton("Try the demo");
  open->setDefault(true);
  for (QPushButton* const button : {open, demo}) button->setMinimumSize(220, 36);
  connect(open, &QPushButton::clicked, this, [run] { run("file.open"); });
  connect(demo, &QPushButton::clicked, this, [run] { run("file.demo"); });
  auto* const column = new QVBoxLayout(this);
  column->addStretch();
  column->addWidget(title);
  column->addSpacing(12);
  column->addWidget(open, 0, Qt::AlignCenter);
  column->addWidget(demo, 0, Qt::AlignCenter);
  column->addStretch();
}

}  // namespace loopscope
