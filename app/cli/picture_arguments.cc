// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/picture_arguments.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/io/replace_file.h"
#include "core/io/words.h"
#include "render/layout.h"
#include "render/picture_format.h"
#include "render/vector/vector_picture.h"

namespace loopscope {

void AddPictureArguments(CLI::App* command, PictureArguments* arguments) {
  command->add_option("--size", arguments->size, "Width and height in pixels (default: 1280x720)")
      ->type_name("WxH");
  command
      ->add_option("--theme", arguments->theme,
                   "Colours: default (Cartographer's), color-blind, dark or dark-color-blind")
      ->type_name("NAME")
      ->check(CLI::IsMember(ThemeNames()));
  command->add_option("--title", arguments->title, "Title instead of the view's own")
      ->type_name("TEXT");
  command->add_flag("--plain", arguments->plain,
                    "Nothing but title and maps: no legend, colour bars and numbers");
  command
      ->add_option("--text", arguments->text_height,
                   "Height of the text in pixels (default: grows with the picture)")
      ->type_name("PIXELS");
  command
      ->add_option(
          "--backend", arguments->backend,
          "Who draws: osmesa, egl, or auto (the default: osmesa if it works). None needs a "
          "display")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
}

void ApplyTo(const PictureArguments& arguments, ViewRequest* request) {
  const std::string_view size = arguments.size;
  const std::size_t cross = std::min(size.find('x'), size.size());
  const auto width = ParseInt(size.substr(0, cross));
  const auto height = ParseInt(size.substr(std::min(cross + 1, size.size())));
  if (!width || !height || *width < kMinPictureWidth || *height < kMinPictureHeight ||
      *width > kMaxPictureSide || *height > kMaxPictureSide) {
    throw std::invalid_argument(fmt::format(
        "--size {}: expected width and height in pixels, {}x{} to {}x{}", arguments.size,
        kMinPictureWidth, kMinPictureHeight, kMaxPictureSide, kMaxPictureSide));
  }
  request->width = *width;
  request->height = *height;
  request->theme = ThemeFromName(arguments.theme);
  request->title = arguments.title;
  request->plain = arguments.plain;
  request->text_height = arguments.text_height;
}

void DrawScene(const Scene& scene, Backend backend, const std::string& path) {
  const PictureFormat format = PictureFormatOf(path);
  if (format == PictureFormat::kPng) {
    WritePng(Painter(backend).Draw(scene), path);
    return;
  }
  ReplaceFile(path, EncodeVectorPicture(scene, format == PictureFormat::kSvg ? VectorFormat::kSvg
                                                                             : VectorFormat::kPdf));
}

void DrawPicture(const Recording& recording, const ViewRequest& request, Backend backend,
                 const std::string& path) {
  DrawScene(BuildScene(recording, request, OversamplingOf(request)), backend, path);
}

}  // namespace loopscope
