// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/plain_branch_and_bound.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "core/matching/search_lattice.h"

namespace loopscope {
namespace {

/// Maxima of `width` neighbours, as a window slides over `values`: entry i is that of values
/// i - width + 1 ... i, as far as there are any.
std::vector<std::uint8_t> SlidingMaxima(const std::vector<std::uint8_t>& values, int width) {
  const int count = static_cast<int>(values.size());
  std::vector<std::uint8_t> maxima;
  std::deque<int> falling;  // places in the window whose values nothing behind them exceeds
  for (int i = 0; i < count + width - 1; ++i) {
    if (i < count) {
      while (!falling.empty() && values[falling.back()] <= values[i]) falling.pop_back();
      falling.push_back(i);
    }
    while (falling.front() <= i - width) falling.pop_front();
    maxima.push_back(values[falling.front()]);
  }
  return maxima;
}

class PlainSearch {
 public:
  PlainSearch(const PlainPrecomputedGrids& grids, const SearchWindow& window,
              const PointCloud& points, double min_score)
      : grids_(grids), window_(window), best_score_(min_score) {
    for (int angle = -window.num_angular_steps; angle <= window.num_angular_steps; ++angle) {
      const Pose2 submap_from_scan = PoseInWindow(window, {0, 0}, angle);
      const Eigen::Matrix2d rotation = submap_from_scan.RotationMatrix();
      std::vector<CellIndex> cells;
      for (const Eigen::Vector2d& point : points) {
        cells.push_back(CellOf(rotation * point + submap_from_scan.translation, window.resolution));
      }
      cells_at_angle_.push_back(std::move(cells));
    }
  }

  std::optional<SearchResult> Run() {
    const int w = window_.num_linear_steps;
    const int step = 1 << grids_.max_height();
    std::vector<Node> start;
    for (int angle = -window_.num_angular_steps; angle <= window_.num_angular_steps; ++angle) {
      for (int x = -w; x <= w; x += step) {
        for (int y = -w; y <= w; y += step) {
          start.push_back(Bound({x, y}, angle, grids_.max_height()));
        }
      }
    }
    Sort(&start);
    for (const Node& node : start) Branch(node);
    return winner_;
  }

 private:
  struct Node {
    CellIndex offset;
    int angle;
    int height;
    double bound;
  };

  Node Bound(CellIndex offset, int angle, int height) const {
    const auto& cells = cells_at_angle_[angle + window_.num_angular_steps];
    int sum = 0;
    for (const CellIndex cell : cells) {
      sum += grids_.value(height, {cell.x + offset.x, cell.y + offset.y});
    }
    return {offset, angle, height,
            0.1 + sum * ((0.9 - 0.1) / 255.0) / static_cast<double>(cells.size())};
  }

  void Branch(const Node& node) {
    if (node.bound <= best_score_) return;
    if (node.height == 0) {
      best_score_ = node.bound;
      winner_ = SearchResult{PoseInWindow(window_, node.offset, node.angle), node.bound};
      return;
    }
    const int half = 1 << (node.height - 1);
    const int w = window_.num_linear_steps;
    std::vector<Node> children;
    for (const int x : {node.offset.x, node.offset.x + half}) {
      for (const int y : {node.offset.y, node.offset.y + half}) {
        if (x <= w && y <= w) children.push_back(Bound({x, y}, node.angle, node.height - 1));
      }
    }
    Sort(&children);
    for (const Node& child : children) Branch(child);
  }

  static void Sort(std::vector<Node>* nodes) {
    std::stable_sort(nodes->begin(), nodes->end(),
                     [](const Node& a, const Node& b) { return a.bound > b.bound; });
  }

  const PlainPrecomputedGrids& grids_;
  const SearchWindow& window_;
  std::vector<std::vector<CellIndex>> cells_at_angle_;
  double best_score_;
  std::optional<SearchResult> winner_;
};

}  // namespace

PlainPrecomputedGrids::PlainPrecomputedGrids(const ProbabilityGrid& grid, int depth) {
  const CellBox known = grid.box();
  for (int height = 0; height < depth; ++height) {
    const int side = 1 << height;
    Level level{{{known.min.x - side + 1, known.min.y - side + 1},
                 known.width + side - 1,
                 known.height + side - 1},
                {}};
    level.values.resize(level.box.num_cells());
    std::vector<std::vector<std::uint8_t>> rows;
    for (int y = 0; y < known.height; ++y) {
      std::vector<std::uint8_t> row;
      for (int x = 0; x < known.width; ++x) {
        const double p = grid.probability({known.min.x + x, known.min.y + y});
        row.push_back(static_cast<std::uint8_t>(std::lround((p - 0.1) / 0.8 * 255.0)));
      }
      rows.push_back(SlidingMaxima(row, side));
    }
    for (int x = 0; x < level.box.width; ++x) {
      std::vector<std::uint8_t> column;
      for (const auto& row : rows) column.push_back(row[x]);
      const std::vector<std::uint8_t> maxima = SlidingMaxima(column, side);
      for (int y = 0; y < level.box.height; ++y) {
        level.values[static_cast<std::size_t>(y) * level.box.width + x] = maxima[y];
      }
    }
    grids_.push_back(std::move(level));
  }
}

std::optional<SearchResult> PlainBranchAndBound(const PlainPrecomputedGrids& grids,
                                                const SearchWindow& window,
                                                const PointCloud& points_in_scan,
                                                double min_score) {
  return PlainSearch(grids, window, points_in_scan, min_score).Run();
}

}  // namespace loopscope
