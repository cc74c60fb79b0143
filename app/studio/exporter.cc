// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/exporter.h"

#include <QApplication>
#include <QRegularExpression>
#include <csignal>

namespace loopscope {

Exporter::Exporter() {
  connect(&program_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          &Exporter::End);
  connect(&program_, &QProcess::readyReadStandardError, this, &Exporter::ReadProgress);
  connect(&program_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    emit Failed("Nothing was exported: " + program_.program() + " cannot be run.");
    emit Ended("");
  });
}

Exporter::~Exporter() {
  constexpr int kMaxMilliseconds = 30'000;
  program_.disconnect(this);
  Stop();
  if (IsRunning()) program_.waitForFinished(kMaxMilliseconds);
}

void Exporter::Start(const std::vector<std::string>& arguments) {
  if (IsRunning()) {
    emit Failed("The picture or film before is still being drawn.");
    return;
  }
  QStringList words;
  for (const std::string& argument : arguments) words.append(QString::fromStdString(argument));
  last_line_.clear();
  is_stopped_ = false;
  program_.start(QApplication::applicationDirPath() + "/loopscope", words);
}

void Exporter::Stop() {
  if (!IsRunning()) return;
  is_stopped_ = true;
  kill(static_cast<pid_t>(program_.processId()), SIGINT);  // as Ctrl+C does in a terminal
}

/// Lines of how far it has come look like " 40 %  12/30 frames"; the last other one says what went
/// wrong.
void Exporter::ReadProgress() {
  static const QRegularExpression progress("^ *([0-9]+) %");
  for (const QString& line : QString::fromUtf8(program_.readAllStandardError()).split('\n')) {
    const QRegularExpressionMatch match = progress.match(line);
    if (match.hasMatch()) {
      emit Progressed(match.captured(1).toInt());
    } else if (!line.trimmed().isEmpty()) {
      last_line_ = line.trimmed();
    }
  }
}

void Exporter::End(int exit_code, QProcess::ExitStatus status) {
  ReadProgress();
  const bool is_done = exit_code == 0 && status == QProcess::NormalExit;
  if (!is_done && !is_stopped_) {
    emit Failed(last_line_.isEmpty() ? "Nothing was exported: loopscope crashed." : last_line_);
  }
  emit Ended(QString::fromUtf8(program_.readAllStandardOutput()).trimmed());
}

}  // namespace loopscope
