// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/svg_images.h"

#include <cmath>
#include <map>
#include <regex>

namespace loopscope {

std::string WithFinishedImages(const std::string& svg) {
  // A name that is given or used; when an image is used, the size of its pixels stands behind it.
  static const std::regex name(
      R"((["#])(image|surface)(\d+)(?=\"(?: transform="matrix\(([-\d.e]+),([-\d.e]+))?))");
  std::map<std::string, std::size_t> numbers;
  std::string finished;
  std::size_t done = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), name), end; it != end; ++it) {
    const std::smatch& match = *it;
    const std::size_t number = numbers.emplace(match[3], numbers.size()).first->second;
    finished.append(svg, done, match.position() - done);
    finished += match.str(1) + match.str(2) + std::to_string(number);
    done = match.position() + match.length();
    if (!match[4].matched) continue;
    const double size = std::hypot(std::stod(match[4]), std::stod(match[5]));
    if (size > 1.0) finished += R"(" style="image-rendering:pixelated)";
  }
  return finished.append(svg, done, std::string::npos);
}

}  // namespace loopscope
