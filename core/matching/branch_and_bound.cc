// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/branch_and_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "core/matching/precomputed_grids.h"
#include "core/matching/search_lattice.h"

namespace loopscope {
namespace {

/// A node c of eqs. 11 and 12 with its bound.
struct Block {
  CellIndex offset;
  int angle_index = 0;
  int height = 0;
  double bound = 0.0;
  int trace_index = -1;
};

/// Offsets of a window that are not of interest.
struct Disc {
  Eigen::Vector2d center;  ///< [cells]
  double radius = 0.0;     ///< [cells]

  bool Holds(double x, double y) const { return (Eigen::Vector2d(x, y) - center).norm() <= radius; }
  /// A disc is convex, so it holds a block if it holds its corners.
  bool Holds(const Block& block) const {
    const int x = block.offset.x;
    const int y = block.offset.y;
    const int last = (1 << block.height) - 1;
    return Holds(x, y) && Holds(x + last, y) && Holds(x, y + last) && Holds(x + last, y + last);
  }
};

/// One run of Algorithm 3.
class Search {
 public:
  Search(const PrecomputedGrids& grids, const SearchWindow& window, const PointCloud& points,
         SearchTrace* trace)
      : grids_(grids), window_(window), trace_(trace) {
    for (int angle = -window.num_angular_steps; angle <= window.num_angular_steps; ++angle) {
      cells_at_angle_.push_back(CellsAtAngle(window, points, angle));
    }
    if (trace_ != nullptr) *trace_ = SearchTrace{window, {}, {}, -1};
  }

  SearchOutcome Run(double min_score) {
    const std::vector<Block> start_blocks = StartBlocks();
    best_score_ = min_score;
    DepthFirst(start_blocks);
    if (!winner_) return Failure(DescendToLeaf(start_blocks.front()));
    if (trace_ != nullptr) trace_->winner = winner_->trace_index;
    const SearchResult result = ResultOf(*winner_);
    return {result, result, result.score};
  }

  /// Any leaf outside of `excluded` that scores more than `min_score`.
  std::optional<SearchResult> RunOutside(const Disc& excluded, double min_score) {
    const std::optional<Block> found = FirstLeafOutside(StartBlocks(), excluded, min_score);
    if (!found) return std::nullopt;
    return ResultOf(*found);
  }

 private:
  /// C_0 of eq. 13, best bound first.
  std::vector<Block> StartBlocks() {
    const int w = window_.num_linear_steps;
    const int height = grids_.max_height();
    std::vector<Block> blocks;
    for (int angle = -window_.num_angular_steps; angle <= window_.num_angular_steps; ++angle) {
      for (int x = -w; x <= w; x += 1 << height) {
        for (int y = -w; y <= w; y += 1 << height) {
          blocks.push_back(Score({x, y}, angle, height, -1));
        }
      }
    }
    SortByBound(&blocks);
    return blocks;
  }

  /// Branches (eq. 14) those of `blocks` whose bound beats the best score. They come best first, so
  /// that all are done with the first that does not.
  void DepthFirst(const std::vector<Block>& blocks) {
    for (const Block& block : blocks) {
      if (block.bound <= best_score_) {
        Decide(block, SearchFate::kPruned);
        pruned_bound_ = std::max(pruned_bound_, block.bound);
        continue;
      }
      if (block.height == 0) {
        Decide(block, SearchFate::kImproved);
        best_score_ = block.bound;
        winner_ = block;
        continue;
      }
      Decide(block, SearchFate::kExpanded);
      DepthFirst(Children(block));
    }
  }

  std::optional<Block> FirstLeafOutside(const std::vector<Block>& blocks, const Disc& excluded,
                                        double min_score) {
    for (const Block& block : blocks) {
      if (block.bound <= min_score) break;
      if (excluded.Holds(block)) continue;
      if (block.height == 0) return block;
      const std::optional<Block> found = FirstLeafOutside(Children(block), excluded, min_score);
      if (found) return found;
    }
    return std::nullopt;
  }

  std::vector<Block> Children(const Block& parent) {
    const int w = window_.num_linear_steps;
    const int half = 1 << (parent.height - 1);
    std::vector<Block> children;
    for (const int x : {parent.offset.x, parent.offset.x + half}) {
      for (const int y : {parent.offset.y, parent.offset.y + half}) {
        if (x > w || y > w) continue;
        children.push_back(
            Score({x, y}, parent.angle_index, parent.height - 1, parent.trace_index));
      }
    }
    SortByBound(&children);
    return children;
  }

  /// The bound of eq. 16.
  Block Score(CellIndex offset, int angle_index, int height, int parent) {
    const PrecomputedGrid& grid = grids_.at_height(height);
    const std::vector<CellIndex>& cells = cells_at_angle_[angle_index + window_.num_angular_steps];
    int sum = 0;
    for (const CellIndex cell : cells) sum += grid.value({cell.x + offset.x, cell.y + offset.y});
    Block block{offset, angle_index, height,
                PrecomputedGrids::MeanProbability(sum, static_cast<int>(cells.size())), -1};
    if (trace_ != nullptr) {
      block.trace_index = static_cast<int>(trace_->nodes.size());
      trace_->nodes.push_back(
          {parent, height, offset, angle_index, block.bound, 0.0, SearchFate::kPruned});
    }
    return block;
  }

  /// Where the bounds are highest, without regard to the best score: a fair answer to "how well
  /// would it have matched" for a search that found nothing.
  Block DescendToLeaf(Block block) {
    SearchTrace* const trace = std::exchange(trace_, nullptr);
    while (block.height > 0) block = Children(block).front();
    trace_ = trace;
    return block;
  }

  SearchOutcome Failure(const Block& best_leaf) const {
    return {std::nullopt, ResultOf(best_leaf), pruned_bound_};
  }

  void Decide(const Block& block, SearchFate fate) {
    if (trace_ == nullptr) return;
    SearchNode& node = trace_->nodes[block.trace_index];
    node.fate = fate;
    node.best_before = best_score_;
    trace_->visits.push_back(block.trace_index);
  }

  SearchResult ResultOf(const Block& leaf) const {
    return {PoseInWindow(window_, leaf.offset, leaf.angle_index), leaf.bound};
  }

  static void SortByBound(std::vector<Block>* blocks) {
    std::stable_sort(blocks->begin(), blocks->end(),
                     [](const Block& a, const Block& b) { return a.bound > b.bound; });
  }

  const PrecomputedGrids& grids_;
  const SearchWindow& window_;
  SearchTrace* trace_;
  std::vector<std::vector<CellIndex>> cells_at_angle_;
  double best_score_ = 0.0;
  double pruned_bound_ = 0.0;
  std::optional<Block> winner_;
};

/// Half the side of a square around the centre of `box` that holds it.
double HalfSide(const CellBox& box, double resolution) {
  return 0.5 * resolution * std::max(box.width, box.height);
}

}  // namespace

BranchAndBoundMatcher::BranchAndBoundMatcher(const ProbabilityGrid& grid, int depth)
    : grids_(std::make_unique<PrecomputedGrids>(grid, depth)) {}

BranchAndBoundMatcher::~BranchAndBoundMatcher() = default;

SearchOutcome BranchAndBoundMatcher::Search(const PointCloud& points_in_scan,
                                            const Pose2& submap_from_scan_guess,
                                            double linear_window, double angular_window,
                                            double min_score, SearchTrace* trace) const {
  assert(!points_in_scan.empty());
  const SearchWindow window = MakeSearchWindow(points_in_scan, submap_from_scan_guess,
                                               linear_window, angular_window, grids_->resolution());
  return loopscope::Search(*grids_, window, points_in_scan, trace).Run(min_score);
}

std::optional<SearchResult> BranchAndBoundMatcher::FindRival(
    const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess, double linear_window,
    double angular_window, const Pose2& winner, double min_distance, double min_score) const {
  const SearchWindow window = MakeSearchWindow(points_in_scan, submap_from_scan_guess,
                                               linear_window, angular_window, grids_->resolution());
  const Disc excluded{(winner.translation - submap_from_scan_guess.translation) / window.resolution,
                      min_distance / window.resolution};
  return loopscope::Search(*grids_, window, points_in_scan, nullptr)
      .RunOutside(excluded, min_score);
}

SearchOutcome BranchAndBoundMatcher::SearchWholeSubmap(const PointCloud& points_in_scan,
                                                       double min_score, SearchTrace* trace) const {
  const CellBox& known = grids_->at_height(0).box();
  const CellIndex center{known.min.x + known.width / 2, known.min.y + known.height / 2};
  const Pose2 submap_from_center(CenterOf(center, grids_->resolution()), 0.0);
  return Search(points_in_scan, submap_from_center, HalfSide(known, grids_->resolution()), M_PI,
                min_score, trace);
}

}  // namespace loopscope
