// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/options_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/io/assignment_search.h"
#include "core/io/file_error.h"
#include "core/io/lua_sandbox.h"
#include "core/io/stock_files.h"
#include "core/io/text_file.h"
#include "core/io/unused_options.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

using Values = std::map<std::string, ConfigValue>;

// "map_builder.pose_graph.x" in the table that is returned is what files call "POSE_GRAPH.x".
std::string KeyInFiles(const std::string& key) {
  constexpr std::pair<std::string_view, std::string_view> kGroups[] = {
      {"map_builder.pose_graph.", "POSE_GRAPH."},
      {"map_builder.", "MAP_BUILDER."},
      {"trajectory_builder.trajectory_builder_2d.", "TRAJECTORY_BUILDER_2D."},
      {"trajectory_builder.trajectory_builder_3d.", "TRAJECTORY_BUILDER_3D."},
      {"trajectory_builder.", "TRAJECTORY_BUILDER."},
  };
  for (const auto& [group, name] : kGroups) {
    if (key.rfind(group, 0) == 0) return std::string(name) + key.substr(group.size());
  }
  return key;
}

// A configuration without these tables would pass for the stock one.
void CheckGroups(const LuaRun& run) {
  for (const std::string group :
       {"map_builder.pose_graph.", "trajectory_builder.trajectory_builder_2d."}) {
    const bool found = std::any_of(run.values.begin(), run.values.end(), [&](const auto& entry) {
      return entry.key.rfind(group, 0) == 0;
    });
    if (found) continue;
    throw FileError(
        run.sources.front().path,
        fmt::format("{} is missing in what it returns; expected options with "
                    "map_builder = MAP_BUILDER, trajectory_builder = TRAJECTORY_BUILDER",
                    group.substr(0, group.size() - 1)));
  }
}

void Set(const OptionRow& row, const ConfigValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return SetValue(*flag, row);
  if (const auto* number = std::get_if<double>(&value)) return SetValue(*number, row);
  throw OptionError(fmt::format("{} = {}: expected {}", row.key, ToLua(value), ExpectedValue(row)));
}

class Interpreter {
 public:
  Interpreter(Values values, const std::vector<LuaSource>& sources)
      : values_(std::move(values)), sources_(sources), file_{CartographerPreset(), {}} {
    for (const OptionRow& row : OptionTable(&file_.options)) used_[row.key] = row;
    for (const UnusedOption& option : UnusedOptions()) unused_[option.key] = option;
  }

  OptionsFile Interpret() {
    CheckIs2D();
    for (const auto& [key, value] : values_) {
      try {
        Take(key, value);
      } catch (const OptionError& error) {
        Fail(key, error.what());
      }
    }
    return std::move(file_);
  }

 private:
  [[noreturn]] void Fail(const std::string& key, const std::string& what) const {
    const std::optional<SourceLine> place = FindAssignment(sources_, key);
    if (place) throw FileError(place->path, place->line, what);
    throw FileError(sources_.front().path, what);
  }

  void CheckIs2D() const {
    const std::string key = "MAP_BUILDER.use_trajectory_builder_3d";
    const auto is_3d = values_.find(key);
    if (is_3d == values_.end() || is_3d->second != ConfigValue(true)) return;
    Fail(key, key + " = true: expected false, as Loopscope maps in 2D");
  }

  void Take(const std::string& key, const ConfigValue& value) {
    if (const auto row = used_.find(key); row != used_.end()) return Set(row->second, value);
    const auto option = unused_.find(key);
    if (option == unused_.end()) throw UnknownOption(key, AllKeys());
    const bool tell = option->second.shapes_map && option->second.stock_value != value;
    if (!tell || PutsScansTogether(key)) return;
    file_.notes.push_back(fmt::format("{} = {} is not used by Loopscope", key, ToLua(value)));
  }

  // Whether as many pieces of a scan are put together as cartographer_ros cuts it into: then scans
  // are whole in the end, as they are here.
  bool PutsScansTogether(const std::string& key) const {
    const auto pieces = values_.find("num_subdivisions_per_laser_scan");
    return key == "TRAJECTORY_BUILDER_2D.num_accumulated_range_data" && pieces != values_.end() &&
           pieces->second == values_.at(key);
  }

  std::vector<std::string> AllKeys() const {
    std::vector<std::string> keys;
    for (const auto& [key, row] : used_) keys.push_back(key);
    for (const auto& [key, option] : unused_) keys.push_back(key);
    return keys;
  }

  Values values_;
  const std::vector<LuaSource>& sources_;
  OptionsFile file_;
  std::map<std::string, OptionRow> used_;  // the rows point into file_
  std::map<std::string, UnusedOption> unused_;
};

}  // namespace

OptionsFile ParseLuaOptions(const std::string& path, const std::string& text) {
  const LuaRun run = RunLua({path, text}, StockFile);
  CheckGroups(run);
  Values values;
  for (const auto& [key, value] : run.values) values[KeyInFiles(key)] = value;
  return Interpreter(std::move(values), run.sources).Interpret();
}

OptionsFile ReadOptionsFile(const std::string& path) {
  const std::string text = ReadTextFile(path);
  const std::string_view end = ".lua";
  const bool is_lua = path.size() >= end.size() && path.substr(path.size() - end.size()) == end;
  if (is_lua) return ParseLuaOptions(path, text);
  try {
    return {ParseOptions(text, LoopscopePreset()), {}};
  } catch (const OptionError& error) {
    throw FileError(path, error.line(), error.what());
  }
}

}  // namespace loopscope
