// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/stock_files.h"

#include <set>
#include <vector>

#include "core/io/unused_stock_options.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

std::vector<ConfigEntry> StockOptions() {
  std::vector<ConfigEntry> entries = UnusedStockOptions();
  Options options = CartographerPreset();
  for (const OptionRow& row : OptionTable(&options)) {
    const ConfigValue value = std::visit([](auto v) -> ConfigValue { return v; }, GetValue(row));
    entries.push_back({row.key, value});
  }
  return entries;
}

// Assignments that make up the global table `name` and all tables in it.
std::string TableText(const std::string& name) {
  std::string text = name + " = {}\n";
  std::set<std::string> tables = {name};
  for (const auto& [key, value] : StockOptions()) {
    if (key.rfind(name + ".", 0) != 0) continue;
    for (size_t dot = key.find('.', name.size() + 1); dot != std::string::npos;
         dot = key.find('.', dot + 1)) {
      const std::string table = key.substr(0, dot);
      if (tables.insert(table).second) text += table + " = {}\n";
    }
    text += key + " = " + ToLua(value) + "\n";
  }
  return text;
}

}  // namespace

std::optional<std::string> StockFile(const std::string& name) {
  if (name == "pose_graph.lua") return TableText("POSE_GRAPH");
  if (name == "trajectory_builder_2d.lua") return TableText("TRAJECTORY_BUILDER_2D");
  if (name == "trajectory_builder_3d.lua") {
    return "MAX_3D_RANGE = 60\nINTENSITY_THRESHOLD = 40\n" + TableText("TRAJECTORY_BUILDER_3D");
  }
  if (name == "map_builder.lua") {
    return "include \"pose_graph.lua\"\n" + TableText("MAP_BUILDER") +
           "MAP_BUILDER.pose_graph = POSE_GRAPH\n";
  }
  if (name == "trajectory_builder.lua") {
    return "include \"trajectory_builder_2d.lua\"\ninclude \"trajectory_builder_3d.lua\"\n" +
           TableText("TRAJECTORY_BUILDER") +
           "TRAJECTORY_BUILDER.trajectory_builder_2d = TRAJECTORY_BUILDER_2D\n"
           "TRAJECTORY_BUILDER.trajectory_builder_3d = TRAJECTORY_BUILDER_3D\n";
  }
  return std::nullopt;
}

}  // namespace loopscope
