// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/film_writer.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/io/file_error.h"
#include "core/io/replace_file.h"
#include "render/video/video_encoder.h"

namespace loopscope {
namespace {

namespace fs = std::filesystem;

enum class FilmFormat { kFolder, kMp4, kAvi };

FilmFormat FormatOf(const std::string& path) {
  const fs::path name(path);
  std::error_code ignored;
  if (name.extension() == ".mp4") return FilmFormat::kMp4;
  if (name.extension() == ".avi") return FilmFormat::kAvi;
  if (!path.empty() && (!name.has_filename() || !name.has_extension())) return FilmFormat::kFolder;
  if (fs::is_directory(name, ignored)) return FilmFormat::kFolder;
  throw std::invalid_argument(path +
                              ": expected a name that ends in .mp4 or .avi, or that of a folder");
}

class FrameFolder : public FilmWriter {
 public:
  explicit FrameFolder(const std::string& path) : folder_(path) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw FileError(path, "cannot be made: " + error.message());
  }

  void Add(const Picture& picture) override { WritePng(picture, NameOf(num_frames_++)); }

  void Finish() override {
    std::error_code error;
    for (int i = num_frames_; fs::remove(NameOf(i), error); ++i) {
    }
  }

 private:
  std::string NameOf(int frame) const {
    return (folder_ / fmt::format("frame_{:06}.png", frame)).string();
  }

  fs::path folder_;
  int num_frames_ = 0;
};

/// The film is written beside its place.
class VideoFile : public FilmWriter {
 public:
  VideoFile(const std::string& path, VideoCodec codec, double frames_per_second)
      : path_(path),
        codec_(codec),
        frames_per_second_(frames_per_second),
        video_(LoadVideoEncoder()) {
    const fs::path name(path);
    beside_ = (name.parent_path() / name.stem()).string() + ".part" + name.extension().string();
    if (fs::is_directory(name)) throw FileError(path, "cannot be written: Is a directory");
    try {
      ReplaceFile(beside_, "");  // says why it cannot be written; the video library does not
    } catch (const FileError& error) {
      const std::string what = error.what();
      throw FileError(path, what.substr(what.rfind(": cannot") + 2));
    }
  }

  ~VideoFile() override {
    video_->Close();
    std::error_code ignored;
    fs::remove(beside_, ignored);
  }

  void Add(const Picture& picture) override {
    if (num_frames_ == 0) Open(picture);
    video_->Add(picture);
    ++num_frames_;
  }

  void Finish() override {
    video_->Close();
    const int num_written = video_->NumFramesOf(beside_);
    if (num_written != num_frames_) {
      throw FileError(path_, fmt::format("cannot be written: of {} frames {} arrived", num_frames_,
                                         num_written));
    }
    std::error_code error;
    fs::rename(beside_, path_, error);
    if (error) throw FileError(path_, "cannot be written: " + error.message());
  }

 private:
  void Open(const Picture& picture) {
    if (!video_->Open(beside_, codec_, frames_per_second_, picture.width, picture.height)) {
      throw FileError(path_, fmt::format("the video library cannot write {}x{} at {} frames/s",
                                         picture.width, picture.height, frames_per_second_));
    }
  }

  std::string path_;
  std::string beside_;
  VideoCodec codec_;
  double frames_per_second_;
  std::unique_ptr<VideoEncoder> video_;
  int num_frames_ = 0;
};

}  // namespace

void RequireFilmPath(const std::string& path) { FormatOf(path); }

std::unique_ptr<FilmWriter> MakeFilmWriter(const std::string& path, double frames_per_second) {
  switch (FormatOf(path)) {
    case FilmFormat::kMp4:
      return std::make_unique<VideoFile>(path, VideoCodec::kMpeg4, frames_per_second);
    case FilmFormat::kAvi:
      return std::make_unique<VideoFile>(path, VideoCodec::kMotionJpeg, frames_per_second);
    case FilmFormat::kFolder:
      break;
  }
  return std::make_unique<FrameFolder>(path);
}

}  // namespace loopscope
