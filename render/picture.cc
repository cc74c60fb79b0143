// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <png.h>
#include <stdexcept>

#include "core/io/file_error.h"
#include "core/io/replace_file.h"

namespace loopscope {
namespace {

/// What libpng knows of an image while it reads or writes it.
class PngImage {
 public:
  PngImage() {
    std::memset(&image_, 0, sizeof(image_));
    image_.version = PNG_IMAGE_VERSION;
  }
  ~PngImage() { png_image_free(&image_); }

  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  png_image* get() { return &image_; }
  png_image* operator->() { return &image_; }

 private:
  png_image image_;
};

}  // namespace

bool operator==(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.rgb == b.rgb;
}

std::string EncodePng(const Picture& picture) {
  PngImage image;
  image->width = static_cast<png_uint_32>(picture.width);
  image->height = static_cast<png_uint_32>(picture.height);
  image->format = PNG_FORMAT_RGB;
  // Without filters, which make files of drawings larger.
  image->flags = PNG_IMAGE_FLAG_FAST;
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* const stream = open_memstream(&bytes, &size);
  if (stream == nullptr) throw std::bad_alloc();
  const bool is_written =
      png_image_write_to_stdio(image.get(), stream, /*convert_to_8bit=*/0, picture.rgb.data(),
                               /*row_stride=*/0, /*colormap=*/nullptr) != 0;
  std::fclose(stream);
  const std::unique_ptr<char, decltype(&std::free)> owner(bytes, &std::free);
  if (!is_written) throw std::runtime_error(std::string("PNG: ") + image->message);
  return std::string(bytes, size);
}

void WritePng(const Picture& picture, const std::string& path) {
  ReplaceFile(path, EncodePng(picture));
}

Picture ReadPng(const std::string& path) {
  PngImage image;
  const bool is_png = std::filesystem::is_regular_file(path) &&
                      png_image_begin_read_from_file(image.get(), path.c_str()) != 0;
  if (!is_png) throw FileError(path, "expected a PNG image");
  if (image->format != PNG_FORMAT_RGB) {
    throw FileError(path, "expected a PNG image with 8 bit RGB pixels");
  }
  Picture picture;
  picture.width = static_cast<int>(image->width);
  picture.height = static_cast<int>(image->height);
  picture.rgb.resize(PNG_IMAGE_SIZE(*image.get()));
  if (png_image_finish_read(image.get(), /*background=*/nullptr, picture.rgb.data(),
                            /*row_stride=*/0, /*colormap=*/nullptr) == 0) {
    throw FileError(path, std::string("damaged PNG: ") + image->message);
  }
  return picture;
}

}  // namespace loopscope
