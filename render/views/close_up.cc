// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/close_up.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/grid/cell.h"
#include "render/layers/outline.h"

namespace loopscope {
namespace {

/// Weight, and the sum of the points by weight.
struct Sum {
  double weight = 0.0;
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
};

}  // namespace

Extent SquareOfMostInterest(const std::vector<PointOfInterest>& points, double size) {
  if (points.empty()) return Extent();
  constexpr double kTiny = 1e-12;              // so that points without weight have a middle, too
  std::map<std::pair<int, int>, Sum> squares;  // by lower left corner, in half sizes
  for (const PointOfInterest& point : points) {
    const CellIndex corner = CellOf(point.point, 0.5 * size);
    for (const auto& [dx, dy] : {std::pair{0, 0}, {-1, 0}, {0, -1}, {-1, -1}}) {
      Sum& sum = squares[{corner.x + dx, corner.y + dy}];
      sum.weight += point.weight + kTiny;
      sum.weighted += (point.weight + kTiny) * point.point;
    }
  }
  const auto most = std::max_element(
      squares.begin(), squares.end(),
      [](const auto& a, const auto& b) { return a.second.weight < b.second.weight; });
  return SquareAround(most->second.weighted / most->second.weight, size);
}

Extent SquareAround(const Eigen::Vector2d& center, double size) {
  const Eigen::Vector2d half(0.5 * size, 0.5 * size);
  return Extent(center - half, center + half);
}

void OutlineCloseUp(int panel, Sheet* sheet) {
  sheet->Add(0, LayerKind::kWindow, [&] {
    return OutlineLayer(sheet->Visible(panel), sheet->palette().ink, sheet->Px(widths::kThin));
  });
}

}  // namespace loopscope
