// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/branch_and_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "core/matching/block_sums.h"
#include "core/matching/precomputed_grids.h"
#include "core/matching/search_lattice.h"

namespace loopscope {
namespace {

/// Children are three heights lower than their parents: 8 x 8 blocks, whose bounds cost little more
/// than one, see SumBlocks. These are the nodes of the paper's tree at every third height.
constexpr int kHeightsPerBranch = 3;
static_assert(1 << kHeightsPerBranch == kBlocksPerSide);
/// Of the start nodes at an angle, unless they are leaves. More of them have tighter bounds.
constexpr int kMaxStartBlocksPerSide = 12;

/// A node c of eqs. 11 and 12 with its bound.
struct Block {
  CellIndex offset;
  int angle_index = 0;
  int height = 0;
  int sum = 0;  ///< of 8-bit values, the bound of eq. 16
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
      : grids_(grids),
        window_(window),
        num_points_(static_cast<int>(points.size())),
        trace_(trace) {
    for (int angle = -window.num_angular_steps; angle <= window.num_angular_steps; ++angle) {
      cells_at_angle_.push_back(CellsAtAngle(window, points, angle));
    }
    if (trace_ != nullptr) *trace_ = SearchTrace{window, {}, {}, -1};
  }

  SearchOutcome Run(double min_score) {
    SetMinScore(min_score);
    const std::vector<Block> start_blocks = StartBlocks();
    DepthFirst(start_blocks);
    if (!winner_) return {std::nullopt, ResultOf(DescendToLeaf()), ScoreOf(pruned_sum_)};
    if (trace_ != nullptr) trace_->winner = winner_->trace_index;
    const SearchResult result = ResultOf(*winner_);
    return {result, result, result.score};
  }

  /// Any leaf outside of `excluded` that scores more than `min_score`.
  std::optional<SearchResult> RunOutside(const Disc& excluded, double min_score) {
    SetMinScore(min_score);
    const std::optional<Block> found = FirstLeafOutside(StartBlocks(), excluded);
    if (!found) return std::nullopt;
    return ResultOf(*found);
  }

 private:
  /// C_0 of eq. 13, best bound first.
  std::vector<Block> StartBlocks() {
    const int w = window_.num_linear_steps;
    const int height = StartHeight();
    const int step = kBlocksPerSide << height;
    std::vector<Block> blocks;
    for (int angle = -window_.num_angular_steps; angle <= window_.num_angular_steps; ++angle) {
      for (int y = -w; y <= w; y += step) {
        for (int x = -w; x <= w; x += step) {
          ScoreSquare({x, y}, {w, w}, angle, height, -1, &blocks);
        }
      }
    }
    SortByBound(&blocks);
    return blocks;
  }

  /// The lowest with few enough blocks.
  int StartHeight() const {
    const int last = 2 * window_.num_linear_steps;
    int height = 0;
    while (height + kHeightsPerBranch <= grids_.max_height() &&
           last >> height >= (height == 0 ? kBlocksPerSide : kMaxStartBlocksPerSide)) {
      height += kHeightsPerBranch;
    }
    return height;
  }

  /// Branches (eq. 14) those of `blocks` whose bound beats the best score. They come best first, so
  /// that all are done with the first that does not.
  void DepthFirst(const std::vector<Block>& blocks) {
    for (const Block& block : blocks) {
      if (block.sum <= best_sum_) {
        Decide(block, SearchFate::kPruned);
        continue;
      }
      if (block.height == 0) {
        Decide(block, SearchFate::kImproved);
        best_sum_ = block.sum;
        best_score_ = ScoreOf(block.sum);
        winner_ = block;
        continue;
      }
      Decide(block, SearchFate::kExpanded);
      DepthFirst(Children(block));
    }
  }

  std::optional<Block> FirstLeafOutside(const std::vector<Block>& blocks, const Disc& excluded) {
    for (const Block& block : blocks) {
      if (excluded.Holds(block)) continue;
      if (block.height == 0) return block;
      const std::optional<Block> found = FirstLeafOutside(Children(block), excluded);
      if (found) return found;
    }
    return std::nullopt;
  }

  std::vector<Block> Children(const Block& parent) {
    const int w = window_.num_linear_steps;
    const int last = (1 << parent.height) - 1;
    std::vector<Block> children;
    ScoreSquare(
        parent.offset, {std::min(parent.offset.x + last, w), std::min(parent.offset.y + last, w)},
        parent.angle_index, parent.height - kHeightsPerBranch, parent.trace_index, &children);
    SortByBound(&children);
    return children;
  }

  /// Adds those of the 8 x 8 blocks from `first` on to `blocks` that begin at `last` or before. But
  /// for a trace, those that do not beat the best score are left out.
  void ScoreSquare(CellIndex first, CellIndex last, int angle_index, int height, int parent,
                   std::vector<Block>* blocks) {
    const int num_rows = std::min(kBlocksPerSide, ((last.y - first.y) >> height) + 1);
    const BlockSums sums =
        SumBlocks(grids_.at_height(height),
                  cells_at_angle_[angle_index + window_.num_angular_steps], first, num_rows);
    for (int j = 0; j < num_rows; ++j) {
      const int y = first.y + (j << height);
      for (int i = 0; i < kBlocksPerSide; ++i) {
        const int x = first.x + (i << height);
        if (x > last.x) break;
        Add({{x, y}, angle_index, height, sums[j * kBlocksPerSide + i], -1}, parent, blocks);
      }
    }
  }

  void Add(Block block, int parent, std::vector<Block>* blocks) {
    if (block.sum <= best_sum_) pruned_sum_ = std::max(pruned_sum_, block.sum);
    if (block.sum > best_start_.sum) best_start_ = block;  // no child's bound is higher
    if (trace_ != nullptr) {
      block.trace_index = static_cast<int>(trace_->nodes.size());
      trace_->nodes.push_back({parent, block.height, block.offset, block.angle_index,
                               ScoreOf(block.sum), 0.0, SearchFate::kPruned});
    }
    if (trace_ != nullptr || block.sum > best_sum_) blocks->push_back(block);
  }

  /// Where the bounds are highest, without regard to the best score: a fair answer to "how well
  /// would it have matched" for a search that found nothing.
  Block DescendToLeaf() {
    trace_ = nullptr;
    best_sum_ = -1;
    Block block = best_start_;
    while (block.height > 0) block = Children(block).front();
    return block;
  }

  void Decide(const Block& block, SearchFate fate) {
    if (trace_ == nullptr) return;
    SearchNode& node = trace_->nodes[block.trace_index];
    node.fate = fate;
    node.best_before = best_score_;
    trace_->visits.push_back(block.trace_index);
  }

  /// Sets the best sum to the largest that scores no more than `min_score`.
  void SetMinScore(double min_score) {
    best_score_ = min_score;
    const int max_sum = 255 * num_points_;
    const double share = (min_score - kMinProbability) / (kMaxProbability - kMinProbability);
    best_sum_ = static_cast<int>(std::clamp(share, -1.0, 1.0) * max_sum);
    while (best_sum_ >= 0 && ScoreOf(best_sum_) > min_score) --best_sum_;
    while (best_sum_ < max_sum && ScoreOf(best_sum_ + 1) <= min_score) ++best_sum_;
    best_sum_ = std::max(best_sum_, -1);
  }

  double ScoreOf(int sum) const { return PrecomputedGrids::MeanProbability(sum, num_points_); }

  SearchResult ResultOf(const Block& leaf) const {
    return {PoseInWindow(window_, leaf.offset, leaf.angle_index), ScoreOf(leaf.sum)};
  }

  static void SortByBound(std::vector<Block>* blocks) {
    std::stable_sort(blocks->begin(), blocks->end(),
                     [](const Block& a, const Block& b) { return a.sum > b.sum; });
  }

  const PrecomputedGrids& grids_;
  const SearchWindow& window_;
  const int num_points_;
  SearchTrace* trace_;
  std::vector<std::vector<CellIndex>> cells_at_angle_;
  Block best_start_{{}, 0, 0, -1, -1};  ///< the start node with the highest bound
  int best_sum_ = -1;
  double best_score_ = 0.0;
  int pruned_sum_ = 0;  ///< the highest bound that was not followed
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
