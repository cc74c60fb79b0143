// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/picture.h"

namespace loopscope {

/// Takes the pictures of a film one after the other. All have the same size.
class FilmWriter {
 public:
  virtual ~FilmWriter() = default;

  /// Throws FileError if the picture cannot be written.
  virtual void Add(const Picture& picture) = 0;

  /// To be called after the last picture, of which there must be one: only now the film takes the
  /// place of one that was there before. Throws FileError if it cannot be written.
  virtual void Finish() = 0;
};

/// Throws std::invalid_argument unless `path` ends in .mp4 or .avi, or names a folder: one that is
/// there, or a name without a dot or with a slash at its end.
void RequireFilmPath(const std::string& path);

/// A film of `frames_per_second` > 0 as MPEG-4 (.mp4) or Motion JPEG (.avi), of which an odd last
/// row or column of pixels is left out, or as a folder of frame_000000.png, frame_000001.png, ...,
/// from which the later frames of a longer film are removed. Throws as RequireFilmPath does, and
/// FileError if nothing can be written there.
std::unique_ptr<FilmWriter> MakeFilmWriter(const std::string& path, double frames_per_second);

}  // namespace loopscope
