// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view_kinds.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace loopscope {
namespace {

template <typename Kind>
using Names = std::vector<std::pair<Kind, std::string>>;

const Names<ViewKind>& ViewNames() {
  static const Names<ViewKind> names{{ViewKind::kMap, "map"},       {ViewKind::kSubmap, "submap"},
                                     {ViewKind::kUpdate, "update"}, {ViewKind::kMatch, "match"},
                                     {ViewKind::kSearch, "search"}, {ViewKind::kGraph, "graph"},
                                     {ViewKind::kTime, "time"},     {ViewKind::kChart, "chart"}};
  return names;
}

const Names<LayerKind>& LayerNames() {
  static const Names<LayerKind> names{{LayerKind::kGrid, "grid"},
                                      {LayerKind::kMisses, "misses"},
                                      {LayerKind::kHits, "hits"},
                                      {LayerKind::kOdds, "odds"},
                                      {LayerKind::kTree, "tree"},
                                      {LayerKind::kRays, "rays"},
                                      {LayerKind::kWindow, "window"},
                                      {LayerKind::kIntra, "intra"},
                                      {LayerKind::kTrajectory, "trajectory"},
                                      {LayerKind::kNodes, "nodes"},
                                      {LayerKind::kRefused, "refused"},
                                      {LayerKind::kInter, "inter"},
                                      {LayerKind::kResiduals, "residuals"},
                                      {LayerKind::kScan, "scan"},
                                      {LayerKind::kCovariances, "covariances"},
                                      {LayerKind::kFrames, "frames"},
                                      {LayerKind::kRobot, "robot"},
                                      {LayerKind::kSelection, "selection"},
                                      {LayerKind::kLabels, "labels"}};
  return names;
}

struct LayerSets {
  std::set<LayerKind> all;
  std::set<LayerKind> by_default;
};

std::set<LayerKind> Union(std::set<LayerKind> some, const std::set<LayerKind>& others) {
  some.insert(others.begin(), others.end());
  return some;
}

const LayerSets& LayerSetsOf(ViewKind kind) {
  using L = LayerKind;
  static const std::set<L> map{L::kGrid,  L::kTrajectory, L::kNodes, L::kFrames,
                               L::kRobot, L::kSelection,  L::kLabels};
  static const std::set<L> submap{L::kGrid, L::kTrajectory, L::kNodes, L::kScan, L::kFrames};
  static const std::set<L> update{L::kGrid, L::kMisses, L::kHits, L::kOdds,
                                  L::kRays, L::kWindow, L::kRobot};
  static const std::set<L> match{L::kGrid, L::kWindow, L::kResiduals, L::kScan, L::kRobot};
  static const std::set<L> search{L::kGrid, L::kTree, L::kWindow, L::kScan, L::kRobot};
  static const std::set<L> graph{L::kGrid,      L::kIntra,     L::kTrajectory, L::kNodes,
                                 L::kInter,     L::kResiduals, L::kFrames,     L::kRobot,
                                 L::kSelection, L::kLabels};
  static const std::set<L> time{L::kGrid,   L::kTrajectory, L::kNodes,     L::kInter,
                                L::kFrames, L::kRobot,      L::kSelection, L::kLabels};
  static const std::set<L> chart{L::kGrid, L::kScan, L::kSelection, L::kLabels};
  static const std::map<ViewKind, LayerSets> sets{
      {ViewKind::kMap, {map, {L::kGrid, L::kTrajectory, L::kRobot, L::kSelection}}},
      {ViewKind::kSubmap, {submap, submap}},
      {ViewKind::kUpdate, {update, update}},
      {ViewKind::kMatch, {match, match}},
      {ViewKind::kSearch, {search, search}},
      {ViewKind::kGraph, {Union(graph, {L::kRefused, L::kCovariances}), graph}},
      {ViewKind::kTime, {Union(time, {L::kIntra}), time}},
      {ViewKind::kChart, {chart, chart}}};
  return sets.at(kind);
}

template <typename Kind>
std::string NameOf(const Names<Kind>& names, Kind kind) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const auto& entry) { return entry.first == kind; });
  return found->second;
}

template <typename Kind>
Kind KindOf(const Names<Kind>& names, const std::string& what, const std::string& name) {
  std::string expected;
  for (const auto& [kind, known] : names) {
    if (known == name) return kind;
    expected += (expected.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument("unknown " + what + " '" + name + "': expected one of " + expected);
}

}  // namespace

ViewKind ViewKindFromName(const std::string& name) { return KindOf(ViewNames(), "view", name); }
std::string ToString(ViewKind kind) { return NameOf(ViewNames(), kind); }

LayerKind LayerKindFromName(const std::string& name) { return KindOf(LayerNames(), "layer", name); }
std::string ToString(LayerKind kind) { return NameOf(LayerNames(), kind); }

const std::set<LayerKind>& LayersOf(ViewKind kind) { return LayerSetsOf(kind).all; }

const std::set<LayerKind>& DefaultLayersOf(ViewKind kind) { return LayerSetsOf(kind).by_default; }

}  // namespace loopscope
