// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/recent_files.h"

#include <QFileInfo>
#include <QSettings>
#include <utility>

namespace loopscope {

RecentFiles::RecentFiles(RunLine run, QWidget* parent)
    : QMenu("Open recent", parent), run_(std::move(run)) {
  Fill();
}

void RecentFiles::Add(const std::string& path) {
  constexpr int kMaxRecent = 10;
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  const QString file = QFileInfo(QString::fromStdString(path)).absoluteFilePath();
  recent.removeAll(file);
  recent.prepend(file);
  while (recent.size() > kMaxRecent) recent.removeLast();
  settings.setValue("recent", recent);
  Fill();
}

QString RecentFiles::Folder() {
  const QStringList recent = QSettings().value("recent").toStringList();
  return recent.isEmpty() ? QString() : QFileInfo(recent.front()).absolutePath();
}

void RecentFiles::Fill() {
  clear();
  for (const QString& file : QSettings().value("recent").toStringList()) {
    addAction(file, this, [this, file] { run_("file.open " + file.toStdString()); });
  }
  setEnabled(!isEmpty());
}

}  // namespace loopscope
