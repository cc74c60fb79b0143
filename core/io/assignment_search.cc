// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/assignment_search.h"

#include <cctype>
#include <sstream>
#include <string_view>

namespace loopscope {
namespace {

bool IsNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
}

// The dotted names that `line` assigns to.
std::vector<std::string_view> AssignedNames(std::string_view line) {
  line = line.substr(0, line.find("--"));
  std::vector<std::string_view> names;
  for (size_t equals = line.find('='); equals != std::string_view::npos;
       equals = line.find('=', equals + 1)) {
    size_t end = equals;
    while (end > 0 && (line[end - 1] == ' ' || line[end - 1] == '\t')) --end;
    size_t begin = end;
    while (begin > 0 && IsNameCharacter(line[begin - 1])) --begin;
    if (begin < end) names.push_back(line.substr(begin, end - begin));
  }
  return names;
}

// Whether `name` is `key`, or its end after a dot.
bool IsEndOf(std::string_view name, std::string_view key) {
  if (name.size() > key.size() || key.substr(key.size() - name.size()) != name) return false;
  return name.size() == key.size() || key[key.size() - name.size() - 1] == '.';
}

}  // namespace

std::optional<SourceLine> FindAssignment(const std::vector<LuaSource>& sources,
                                         const std::string& key) {
  std::optional<SourceLine> found;
  size_t longest = 0;
  for (const LuaSource& source : sources) {
    const size_t longest_before = longest;
    std::istringstream lines(source.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      for (const std::string_view name : AssignedNames(line)) {
        // Later lines of a source win over its earlier ones, but not over earlier sources.
        if (!IsEndOf(name, key) || name.size() < longest) continue;
        if (name.size() == longest && longest == longest_before) continue;
        longest = name.size();
        found = SourceLine{source.path, number};
      }
    }
  }
  return found;
}

}  // namespace loopscope
