// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/io/words.h"

namespace loopscope {
namespace {

std::vector<std::string_view> SplitAtColons(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
       colon = text.find(':')) {
    parts.push_back(text.substr(0, colon));
    text.remove_prefix(colon + 1);
  }
  parts.push_back(text);
  return parts;
}

}  // namespace

StepRange ParseStepRange(const std::string& text, int num_steps) {
  const std::vector<std::string_view> parts = SplitAtColons(text);
  const auto number = [&](std::size_t part, int otherwise) -> std::optional<int> {
    if (part >= parts.size() || (part < 2 && parts[part].empty())) return otherwise;
    return ParseInt(parts[part]);
  };
  const auto first = number(0, 0);
  const auto last = number(1, num_steps - 1);
  const auto stride = number(2, 1);
  const bool is_range = (parts.size() == 2 || parts.size() == 3) && first && last && stride;
  if (!is_range || *first < 0 || *last < *first || *last >= num_steps || *stride < 1) {
    throw std::invalid_argument(
        fmt::format("steps {}: expected FIRST:LAST or FIRST:LAST:STRIDE, from 0 to {}, the first "
                    "not behind the last, the stride 1 or more",
                    text, num_steps - 1));
  }
  return {*first, *last, *stride};
}

ViewRequest WithCameraOf(DerivedCache* cache, ViewRequest request, int step) {
  const std::set<ViewKind> fixed{ViewKind::kMap, ViewKind::kGraph, ViewKind::kTime};
  if (fixed.count(request.view) == 0) return request;
  request.step = step;
  const Scene scene = BuildScene(cache, request);
  const Panel& main = scene.panels.front();
  if (!request.center) request.center = main.camera.center;
  if (!request.width_in_meters) {
    request.width_in_meters = main.camera.meters_per_pixel * main.frame.width;
  }
  return request;
}

}  // namespace loopscope
