// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/session_state.h"

#include <stdexcept>
#include <tuple>

namespace loopscope {

bool operator==(const ViewCamera& a, const ViewCamera& b) {
  return a.center == b.center && a.width_in_meters == b.width_in_meters &&
         a.height_in_meters == b.height_in_meters;
}

bool operator==(const ViewSettings& a, const ViewSettings& b) {
  return a.layers == b.layers && a.opacities == b.opacities && a.camera == b.camera;
}

bool operator==(const TableSettings& a, const TableSettings& b) {
  return std::tie(a.filter, a.sort_by, a.descending) == std::tie(b.filter, b.sort_by, b.descending);
}

bool operator==(const SessionState& a, const SessionState& b) {
  const auto fields = [](const SessionState& s) {
    return std::tie(s.step, s.tiles, s.active_tile, s.node, s.submap, s.loops, s.search.num_visits,
                    s.search.height, s.search.angle_index, s.chart, s.views, s.tables, s.theme);
  };
  return fields(a) == fields(b);
}

TableKind TableKindFromName(const std::string& name) {
  for (const TableKind kind : {TableKind::kLoops, TableKind::kSubmaps, TableKind::kNodes}) {
    if (ToString(kind) == name) return kind;
  }
  throw std::invalid_argument("no table '" + name + "': expected loops, submaps or nodes");
}

std::string ToString(TableKind kind) {
  switch (kind) {
    case TableKind::kLoops:
      return "loops";
    case TableKind::kSubmaps:
      return "submaps";
    case TableKind::kNodes:
      break;
  }
  return "nodes";
}

}  // namespace loopscope
