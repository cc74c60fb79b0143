// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/mapping_worker.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "core/io/recording_file.h"

namespace loopscope {

MappingWorker::MappingWorker(ScanLog log, const Options& options, std::string path)
    : log_(std::move(log)), options_(options), path_(std::move(path)) {}

MappingWorker::~MappingWorker() {
  Stop();
  if (thread_.joinable()) thread_.join();
}

void MappingWorker::Start() {
  thread_ = std::thread([this] { Run(); });
}

std::vector<SlamUpdate> MappingWorker::TakeUpdates() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(updates_, {});
}

MappingProgress MappingWorker::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

void MappingWorker::Run() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  // One core is left to the window.
  const int num_threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  try {
    RecordingWriter writer(path_, log_, options_);
    MapLog(log_, options_, num_threads, &writer,
           [&](const SlamUpdate& update, const MappingProgress& progress) {
             seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
             bool was_empty = false;
             {
               const std::lock_guard<std::mutex> lock(mutex_);
               was_empty = updates_.empty();
               updates_.push_back(update);
               progress_ = progress;
             }
             if (was_empty) emit Grown();
             return !stopping_;
           });
    if (progress().num_steps == progress().num_scans) writer.Finish(seconds_);
  } catch (const std::exception& error) {
    error_ = error.what();
  }
  emit Finished();
}

}  // namespace loopscope
