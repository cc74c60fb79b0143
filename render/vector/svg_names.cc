// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/svg_names.h"

#include <map>
#include <regex>

namespace loopscope {

std::string WithOwnNames(const std::string& svg) {
  static const std::regex name(R"re((["#])(image|surface)(\d+)")re");
  std::map<std::string, std::size_t> numbers;
  std::string named;
  std::size_t done = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), name), end; it != end; ++it) {
    const std::smatch& match = *it;
    const std::size_t number = numbers.emplace(match[3], numbers.size()).first->second;
    named.append(svg, done, match.position() - done);
    named += match.str(1) + match.str(2) + std::to_string(number) + '"';
    done = match.position() + match.length();
  }
  return named.append(svg, done, std::string::npos);
}

}  // namespace loopscope
