// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace loopscope {

/// Places in the global frame, in square bins: finds those near another one without a look at all
/// that there are.
class PlaceIndex {
 public:
  void Clear() { bins_.clear(); }
  void Add(int id, const Eigen::Vector2d& place);

  /// Ids of all places within `distance` [m], and of some that are farther, ascending.
  std::vector<int> Near(const Eigen::Vector2d& place, double distance) const;

 private:
  using Bin = std::pair<double, double>;  ///< column and row: whole numbers without bounds

  std::map<Bin, std::vector<int>> bins_;
};

}  // namespace loopscope
