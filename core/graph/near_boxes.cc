// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/near_boxes.h"

#include <algorithm>
#include <numeric>

namespace loopscope {

std::vector<std::pair<int, int>> NearBoxes(const std::vector<Eigen::AlignedBox2d>& boxes,
                                           double distance) {
  std::vector<int> by_left_side(boxes.size());
  std::iota(by_left_side.begin(), by_left_side.end(), 0);
  std::sort(by_left_side.begin(), by_left_side.end(), [&](int a, int b) {
    return std::pair(boxes[a].min().x(), a) < std::pair(boxes[b].min().x(), b);
  });
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> open;  // those that reach to the left side of the next one, or nearly
  for (const int next : by_left_side) {
    const double least_right_side = boxes[next].min().x() - distance;
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](int box) { return boxes[box].max().x() < least_right_side; }),
               open.end());
    for (const int box : open) {
      if (boxes[box].exteriorDistance(boxes[next]) <= distance) {
        pairs.emplace_back(std::max(box, next), std::min(box, next));
      }
    }
    open.push_back(next);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace loopscope
