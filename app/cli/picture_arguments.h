// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/headless/painter.h"
#include "render/view.h"

namespace CLI {
class App;
}

namespace loopscope {

/// The arguments that say how big a picture is, how it looks, and who draws it.
struct PictureArguments {
  std::string size = "1280x720";
  std::string theme = "default";
  std::string title;
  bool plain = false;
  std::optional<int> text_height;  // [px]
  std::string backend = "auto";
};

void AddPictureArguments(CLI::App* command, PictureArguments* arguments);

/// Puts them into a request. Throws std::invalid_argument.
void ApplyTo(const PictureArguments& arguments, ViewRequest* request);

/// Draws the scene and writes it as PNG, SVG or PDF, as the name of the file ends. Throws
/// std::invalid_argument, std::runtime_error or FileError.
void DrawScene(const Scene& scene, Backend backend, const std::string& path);

/// Likewise, the picture of a view.
void DrawPicture(const Recording& recording, const ViewRequest& request, Backend backend,
                 const std::string& path);

}  // namespace loopscope
