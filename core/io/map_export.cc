// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/map_export.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/io/replace_file.h"

namespace loopscope {
namespace {

constexpr double kOccupiedThreshold = 0.65;
constexpr double kFreeThreshold = 0.196;
constexpr int kUnknownPixel = 205;

int TrinaryPixel(float probability) {
  if (probability > kOccupiedThreshold) return 0;
  return probability < kFreeThreshold ? 254 : kUnknownPixel;
}

int GreyPixel(float probability) {
  const int grey = std::clamp(static_cast<int>(std::lround(255.0 * (1.0 - probability))), 0, 254);
  return grey == kUnknownPixel ? kUnknownPixel - 1 : grey;
}

std::string ToPgm(const OccupancyMap& map, MapPixels pixels) {
  std::string pgm = fmt::format("P5\n# {} m per pixel\n{} {}\n255\n", map.resolution, map.box.width,
                                map.box.height);
  for (int y = map.box.min.y + map.box.height - 1; y >= map.box.min.y; --y) {
    for (int x = map.box.min.x; x < map.box.min.x + map.box.width; ++x) {
      const float probability = map.probability({x, y});
      const int pixel = std::isnan(probability)         ? kUnknownPixel
                        : pixels == MapPixels::kTrinary ? TrinaryPixel(probability)
                                                        : GreyPixel(probability);
      pgm.push_back(static_cast<char>(pixel));
    }
  }
  return pgm;
}

std::string ToYaml(const OccupancyMap& map, const std::string& image) {
  const Eigen::Vector2d lower_left =
      CenterOf(map.box.min, map.resolution) - Eigen::Vector2d::Constant(0.5 * map.resolution);
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [{:.6f}, {:.6f}, 0]\nnegate: 0\n"
      "occupied_thresh: {}\nfree_thresh: {}\n",
      image, map.resolution, lower_left.x(), lower_left.y(), kOccupiedThreshold, kFreeThreshold);
}

}  // namespace

MapFiles ExportMap(const OccupancyMap& map, MapPixels pixels, const std::string& path) {
  std::filesystem::path stem(path);
  if (stem.extension() == ".pgm" || stem.extension() == ".yaml") stem.replace_extension();
  const MapFiles files{stem.string() + ".pgm", stem.string() + ".yaml"};
  ReplaceFile(files.image, ToPgm(map, pixels));
  ReplaceFile(files.yaml, ToYaml(map, stem.filename().string() + ".pgm"));
  return files;
}

}  // namespace loopscope
