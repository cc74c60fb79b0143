// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/picture.h"

namespace loopscope {

enum class VideoCodec { kMpeg4, kMotionJpeg };

/// Writes a video file; one at a time.
class VideoEncoder {
 public:
  virtual ~VideoEncoder() = default;

  /// Begins a file of pictures of this size. Whether it can be written.
  virtual bool Open(const std::string& path, VideoCodec codec, double frames_per_second, int width,
                    int height) = 0;
  virtual void Add(const Picture& picture) = 0;
  virtual void Close() = 0;

  /// How many frames can be read from a file; 0 if it is none.
  virtual int NumFramesOf(const std::string& path) const = 0;
};

/// The name of the function in the library of this folder that makes an encoder, owned by the
/// caller. The library is loaded when a film is made: the codecs that it needs are two hundred
/// libraries, which took most of the time of every start of the program.
constexpr char kVideoEncoderMaker[] = "LoopscopeMakeVideoEncoder";
using VideoEncoderMaker = VideoEncoder* (*)();

/// Loads the library, from beside the program. Throws std::runtime_error if it is not there.
std::unique_ptr<VideoEncoder> LoadVideoEncoder();

}  // namespace loopscope
