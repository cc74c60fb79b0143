// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "render/video/video_encoder.h"

namespace loopscope {

std::unique_ptr<VideoEncoder> LoadVideoEncoder() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path path = program.parent_path() / "libloopscope_video.so";
  // Never closed: what it loads does not like to be unloaded.
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const maker = library ? dlsym(library, kVideoEncoderMaker) : nullptr;
  if (!maker) throw std::runtime_error(std::string("cannot write films: ") + dlerror());
  return std::unique_ptr<VideoEncoder>(reinterpret_cast<VideoEncoderMaker>(maker)());
}

}  // namespace loopscope
