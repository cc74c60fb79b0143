// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProcess>
#include <string>
#include <vector>

namespace loopscope {

/// Draws pictures and films with the very program whose command line the window tells, so that what
/// is exported is what that draws.
class Exporter : public QObject {
  Q_OBJECT

 public:
  Exporter();
  /// As Stop, and waits until the film is there.
  ~Exporter() override;

  /// Runs `loopscope` with `arguments`, unless it runs already.
  void Start(const std::vector<std::string>& arguments);
  /// Ends it; of a film the pictures until then stay.
  void Stop();
  bool IsRunning() const { return program_.state() != QProcess::NotRunning; }

 signals:
  /// How much of a film is there [%].
  void Progressed(int percent);
  /// `summary` is what it printed; empty if it failed.
  void Ended(const QString& summary);
  void Failed(const QString& message);

 private:
  void ReadProgress();
  void End(int exit_code, QProcess::ExitStatus status);

  QString last_line_;  // on stderr
  bool is_stopped_ = false;
  QProcess program_;
};

}  // namespace loopscope
