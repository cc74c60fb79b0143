// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/mapping.h"
#include "core/slam/recording.h"

namespace loopscope {

/// Maps a log on a thread of its own, into a file, and hands out what comes about.
class MappingWorker : public QObject {
  Q_OBJECT

 public:
  MappingWorker(ScanLog log, const Options& options, std::string path);
  /// Stops after the scan that it works on.
  ~MappingWorker() override;

  /// Begins. Signals are emitted on the worker's thread, the first perhaps before this returns.
  void Start();

  const std::string& path() const { return path_; }

  /// What came about since the last call, and how far it is.
  std::vector<SlamUpdate> TakeUpdates();
  MappingProgress progress() const;
  double seconds() const { return seconds_; }

  void Stop() { stopping_ = true; }
  /// What went wrong; empty if nothing did. To be asked after Finished.
  const std::string& error() const { return error_; }

 signals:
  /// There are updates to take.
  void Grown();
  /// The file is closed: mapping went to its end, was stopped, or failed.
  void Finished();

 private:
  void Run();

  const ScanLog log_;
  const Options options_;
  std::string path_;
  std::string error_;
  std::atomic<bool> stopping_{false};
  std::atomic<double> seconds_{0.0};
  mutable std::mutex mutex_;
  std::vector<SlamUpdate> updates_;
  MappingProgress progress_;
  std::thread thread_;
};

}  // namespace loopscope
