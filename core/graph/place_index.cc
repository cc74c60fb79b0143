// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/place_index.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

constexpr double kBinSize = 10.0;  // [m]

std::pair<double, double> BinOf(const Eigen::Vector2d& place) {
  return {std::floor(place.x() / kBinSize), std::floor(place.y() / kBinSize)};
}

}  // namespace

void PlaceIndex::Add(int id, const Eigen::Vector2d& place) { bins_[BinOf(place)].push_back(id); }

std::vector<int> PlaceIndex::Near(const Eigen::Vector2d& place, double distance) const {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(distance);
  const Bin first = BinOf(place - reach);
  const Bin last = BinOf(place + reach);
  std::vector<int> ids;
  auto it = bins_.lower_bound(first);
  while (it != bins_.end() && it->first <= last) {
    const auto& [column, row] = it->first;
    if (row < first.second) {
      it = bins_.lower_bound({column, first.second});
    } else if (row > last.second) {
      it = bins_.lower_bound({column + 1.0, first.second});
    } else {
      ids.insert(ids.end(), it->second.begin(), it->second.end());
      ++it;
    }
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace loopscope
