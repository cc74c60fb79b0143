// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/run_opener.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QtConcurrent>
#include <exception>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/io/carmen_log.h"
#include "core/io/log_stem.h"
#include "core/io/recording_file.h"

namespace loopscope {
namespace {

std::shared_ptr<ReadFile> ReadAny(const std::string& path) {
  auto file = std::make_shared<ReadFile>();
  file->path = path;
  try {
    if (IsRecording(path)) {
      file->recording = ReadRecording(path);
    } else {
      file->log = ReadCarmenLog(path);
    }
  } catch (const std::exception& error) {
    file->error = error.what();
  }
  return file;
}

bool IsSameFile(const std::string& a, const std::string& b) {
  return QFileInfo(QString::fromStdString(a)) == QFileInfo(QString::fromStdString(b));
}

/// A file for the recording of a log that does not exist yet: beside that file if that is possible,
/// else in the person's folder for data.
std::string NewRecordingPath(const std::string& beside, const std::string& log_name) {
  QString folder = QFileInfo(QString::fromStdString(beside)).absolutePath();
  if (!QFileInfo(folder).isWritable()) {
    folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    QDir().mkpath(folder);
  }
  const QFileInfo log(QString::fromStdString(log_name));
  const QString name = QString::fromStdString(LogStem(log.fileName().toStdString()));
  QString path = folder + "/" + name + ".loopscope";
  for (int i = 2; QFileInfo::exists(path); ++i) {
    path = QString("%1/%2-%3.loopscope").arg(folder, name).arg(i);
  }
  return path.toStdString();
}

}  // namespace

RunOpener::RunOpener() {
  connect(&reading_, &QFutureWatcherBase::finished, this, &RunOpener::TakeFile);
}

RunOpener::~RunOpener() { reading_.waitForFinished(); }

void RunOpener::Open(const std::string& path, const Options& options) {
  if (mapping_ && IsSameFile(path, mapping_->path())) {
    emit Failed(QString::fromStdString(path + " is being mapped: it is what is shown"));
    return;
  }
  options_ = options;
  is_reading_ = true;
  emit Reading(QString::fromStdString(path));
  reading_.setFuture(QtConcurrent::run([path] { return ReadAny(path); }));
}

void RunOpener::TakeFile() {
  if (!std::exchange(is_reading_, false)) return;
  const std::shared_ptr<ReadFile> file = reading_.result();
  if (!file->error.empty()) {
    emit Failed(QString::fromStdString(file->error));
    return;
  }
  emit HasRead(file->path);
  if (file->log) {
    Map(*file->log, options_, file->path);
  } else {
    mapping_.reset();
    emit Opened(file->path, std::make_shared<Recording>(std::move(*file->recording)));
  }
}

void RunOpener::Map(ScanLog log, const Options& options, const std::string& beside) {
  mapping_.reset();
  const std::string path = NewRecordingPath(beside, log.name);
  emit Opened(path, std::make_shared<Recording>(log, options));
  mapping_ = std::make_unique<MappingWorker>(std::move(log), options, path);
  connect(mapping_.get(), &MappingWorker::Grown, this, &RunOpener::TakeUpdates);
  connect(mapping_.get(), &MappingWorker::Finished, this, &RunOpener::EndMapping);
  mapping_->Start();
}

void RunOpener::Stop() {
  is_reading_ = false;
  if (mapping_) mapping_->Stop();
}

MappingProgress RunOpener::progress() const {
  return mapping_ ? mapping_->progress() : MappingProgress();
}

double RunOpener::seconds() const { return mapping_ ? mapping_->seconds() : 0.0; }

void RunOpener::TakeUpdates() {
  if (sender() != mapping_.get() || !mapping_) return;
  emit Grown(mapping_->TakeUpdates());
}

void RunOpener::EndMapping() {
  if (sender() != mapping_.get() || !mapping_) return;
  emit Grown(mapping_->TakeUpdates());
  const MappingProgress end = mapping_->progress();
  const std::string error = mapping_->error();
  const std::string summary =
      fmt::format("{}: {} of {} scans in {:.1f} s, {} loops closed", mapping_->path(),
                  end.num_steps, end.num_scans, mapping_->seconds(), end.num_loops);
  mapping_.reset();
  if (!error.empty()) emit Failed(QString::fromStdString(error));
  emit Mapped(QString::fromStdString(summary));
}

}  // namespace loopscope
