// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "app/studio/mapping_worker.h"
#include "core/slam/recording.h"

namespace loopscope {

/// A file that was read: one of the first two, or an error.
struct ReadFile {
  std::string path;
  std::optional<Recording> recording;
  std::optional<ScanLog> log;
  std::string error;  ///< one line
};

/// Opens recordings, and maps logs into new recordings, while the window goes on. A new file
/// replaces what was opened or mapped before.
class RunOpener : public QObject {
  Q_OBJECT

 public:
  RunOpener();
  ~RunOpener() override;

  /// Reads a recording or a log. A log is then mapped with `options`.
  void Open(const std::string& path, const Options& options);
  /// Maps a log that is known already. The recording is put beside a file, the log or a recording.
  void Map(ScanLog log, const Options& options, const std::string& beside);
  /// Forgets a file that is being read, and stops mapping; what was mapped until now stays.
  void Stop();

  bool IsReading() const { return is_reading_; }
  bool IsMapping() const { return mapping_ != nullptr; }
  MappingProgress progress() const;
  double seconds() const;

 signals:
  void Reading(const QString& path);
  /// The file could be read.
  void HasRead(const std::string& path);
  /// There is another recording; that of a log has no steps yet.
  void Opened(const std::string& path, const std::shared_ptr<Recording>& recording);
  void Grown(const std::vector<SlamUpdate>& updates);
  /// Mapping went to its end or was stopped.
  void Mapped(const QString& summary);
  void Failed(const QString& message);

 private:
  void TakeFile();
  void TakeUpdates();
  void EndMapping();

  QFutureWatcher<std::shared_ptr<ReadFile>> reading_;
  bool is_reading_ = false;  // a file that is wanted still, until it is taken
  Options options_;
  std::unique_ptr<MappingWorker> mapping_;
};

}  // namespace loopscope
