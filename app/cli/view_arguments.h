// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/picture_arguments.h"
#include "render/view.h"

namespace loopscope {

/// The arguments that say what a picture shows, but for the step.
struct ViewArguments {
  std::string view = "map";
  std::optional<int> node;
  std::optional<int> submap;
  std::vector<std::string> marked;  // N:M
  SearchFilter search;
  std::vector<std::string> layers;
  std::vector<double> center;
  std::optional<double> width_in_meters;
  std::optional<double> height_in_meters;
  std::optional<std::string> chart;
  std::optional<double> azimuth;
  std::optional<double> elevation;
  PictureArguments picture;
};

void AddViewArguments(CLI::App* command, ViewArguments* arguments);

/// What they ask for, of the last step. Throws std::invalid_argument.
ViewRequest ToRequest(const ViewArguments& arguments, const Recording& recording);

}  // namespace loopscope
