// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/branch_and_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory_resource>
#include <utility>
#include <vector>

#include "core/matching/block_sums.h"
#include "core/matching/precomputed_grids.h"
#include "core/matching/search_block.h"
#include "core/matching/search_lattice.h"
#include "core/matching/sector_queue.h"
#include "core/matching/start_queue.h"
#include "core/matching/turned_scan.h"

namespace loopscope {
namespace {

/// Children are three heights lower than their parents: 8 x 8 blocks, whose bounds cost little more
/// than one, see SumBlocks. These are the nodes of the paper's tree at every third height.
constexpr int kHeightsPerBranch = 3;
static_assert(1 << kHeightsPerBranch == kBlocksPerSide);

/// Start nodes that a search branches before it refines the others: most searches end before.
constexpr std::size_t kNumBranchedBeforeRefining = 20;

/// Angles whose cells memory is taken for at once: those of a small window.
constexpr std::size_t kNumAnglesAtOnce = 32;

/// Offsets of a window that are not of interest.
struct Disc {
  Eigen::Vector2d center;  ///< [cells]
  double radius = 0.0;     ///< [cells]

  bool Holds(double x, double y) const { return (Eigen::Vector2d(x, y) - center).norm() <= radius; }
  /// A disc is convex, so it holds a block if it holds its corners.
  bool Holds(const SearchBlock& block) const {
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
        scan_(window, points),
        num_points_(static_cast<int>(points.size())),
        trace_(trace),
        memory_(num_points_ * sizeof(CellIndex) * kNumAnglesAtOnce),
        cells_at_angle_(2 * window.num_angular_steps + 1) {
    if (trace_ != nullptr) *trace_ = SearchTrace{window, {}, {}, -1};
  }

  SearchOutcome Run(double min_score) {
    SetMinScore(min_score);
    MakeSectors();
    while (const std::optional<SearchBlock> block = NextStartBlock(nullptr)) Branch(*block);
    if (trace_ != nullptr) PruneRest();
    if (!winner_) {
      OpenSectorsDownTo(pruned_sum_);
      return {std::nullopt, std::nullopt, ResultOf(DescendToLeaf()), ScoreOf(pruned_sum_)};
    }
    if (trace_ != nullptr) trace_->winner = winner_->trace_index;
    const SearchResult result = ResultOf(*winner_);
    return {result, std::nullopt, result, result.score};
  }

  /// The same, and then any leaf that is a rival: among the start nodes that were branched, and
  /// then among the others.
  SearchOutcome RunWithRival(double min_score, const RivalCriterion& criterion) {
    rival_share_ = criterion.min_relative_score;
    SearchOutcome outcome = Run(min_score);
    if (outcome.winner) outcome.rival = Rival(*outcome.winner, criterion);
    return outcome;
  }

 private:
  std::optional<SearchResult> Rival(const SearchResult& winner, const RivalCriterion& criterion) {
    const Eigen::Vector2d from_guess =
        winner.submap_from_scan.translation - window_.submap_from_scan_guess.translation;
    const Disc excluded{from_guess / window_.resolution,
                        criterion.min_distance / window_.resolution};
    SetMinScore(criterion.min_relative_score * winner.score);
    pruned_sum_ = 0;  // by the score of the winner
    const std::optional<SearchBlock> in_branched = FirstLeafOutside(branched_, excluded);
    if (in_branched) return ResultOf(*in_branched);
    while (const std::optional<SearchBlock> block = NextStartBlock(&excluded)) {
      const std::optional<SearchBlock> found = FirstLeafOutside({*block}, excluded);
      if (found) return ResultOf(*found);
    }
    return std::nullopt;
  }

  /// All start nodes C_0 (eq. 13), in sectors. A trace wants each by itself, and a window of one
  /// square has too few sectors for their bounds to pay.
  void MakeSectors() {
    start_height_ = StartHeight();
    const bool is_one_square = 2 * window_.num_linear_steps < kBlocksPerSide << start_height_;
    const bool with_bounds = trace_ == nullptr && start_height_ > 0 && !is_one_square;
    sectors_.emplace(grids_, window_, scan_, start_height_, with_bounds);
  }

  /// The start node with the highest bound that is not excluded, if that beats the best score.
  std::optional<SearchBlock> NextStartBlock(const Disc* excluded) {
    const int min_bound = best_sum_ + 1;
    while (true) {
      OpenSectorsDownTo(queue_.empty() ? min_bound : std::max(min_bound, queue_.top().sum));
      if (queue_.empty()) return std::nullopt;
      if (queue_.top().sum < min_bound) break;
      if (excluded != nullptr && excluded->Holds(queue_.top())) {
        queue_.Pop();
      } else if (start_height_ == 0 || branched_.size() < kNumBranchedBeforeRefining ||
                 queue_.TopIsRefined()) {
        branched_.push_back(queue_.Pop());
        return branched_.back();
      } else {
        RefineTop();
      }
    }
    pruned_sum_ = std::max(pruned_sum_, queue_.top().sum);
    return std::nullopt;
  }

  /// Lowers the bounds of the best start node and of those beside it, which costs as much as to go
  /// down to the leaves of one, but saves that of most.
  void RefineTop() {
    const PrecomputedGrid& grid = grids_.at_height(start_height_ - StartQueue::kHeightsDownToParts);
    queue_.RefineTop(
        SumBlocks(grid, CellsAt(queue_.top().angle_index), num_points_, queue_.GroupOfTop()));
  }

  /// Gives those start nodes bounds of their own that are in sectors with at least `min_bound`, and
  /// then in those with at least the bound of what was found in these, or pruned.
  void OpenSectorsDownTo(int min_bound) {
    while (const std::optional<Sector> sector = sectors_->Pop(min_bound)) {
      for (int angle = sector->first_angle; angle <= sector->last_angle; ++angle) {
        AddStartNodes(*sector, angle);
      }
      min_bound = std::max(min_bound, pruned_sum_);
      if (!queue_.empty()) min_bound = std::max(min_bound, queue_.top().sum);
    }
  }

  void AddStartNodes(const Sector& sector, int angle_index) {
    constexpr int kNoParent = -1;
    const SearchSquare square =
        ScoredSquare(sector.first, sector.last, angle_index, start_height_, kNoParent);
    const int max_sum = square.MaxSum();
    if (max_sum <= best_sum_) pruned_sum_ = std::max(pruned_sum_, max_sum);
    const bool is_wanted = trace_ != nullptr || MayHoldRival(max_sum);
    if (!is_wanted && max_sum < best_start_.sum) return;
    const SearchBlock best = square.Best(max_sum);
    best_start_ = std::max(best_start_, best);
    if (is_wanted) queue_.Push(square, best);
  }

  /// Of a sum, whether nodes that it bounds may hold the winner or a rival of it.
  bool MayHoldRival(int sum) const { return ScoreOf(sum) > rival_share_ * best_score_; }

  /// Where bounds begin to tell places apart. Higher ones are nearly always as high as can be.
  int StartHeight() const {
    const bool is_one_square = 2 * window_.num_linear_steps < kBlocksPerSide;
    return is_one_square || grids_.max_height() < kHeightsPerBranch ? 0 : kHeightsPerBranch;
  }

  /// Branches (eq. 14) a node whose bound beats the best score, and its children, best first.
  void Branch(const SearchBlock& block) {
    if (block.height == 0) {
      Decide(block, SearchFate::kImproved);
      best_sum_ = block.sum;
      best_score_ = ScoreOf(block.sum);
      winner_ = block;
      return;
    }
    Decide(block, SearchFate::kExpanded);
    for (const SearchBlock& child : Children(block)) {
      if (child.sum > best_sum_) {
        Branch(child);
      } else {
        Decide(child, SearchFate::kPruned);
      }
    }
  }

  void PruneRest() {
    while (!queue_.empty()) Decide(queue_.Pop(), SearchFate::kPruned);
  }

  std::optional<SearchBlock> FirstLeafOutside(const std::vector<SearchBlock>& blocks,
                                              const Disc& excluded) {
    for (const SearchBlock& block : blocks) {
      if (excluded.Holds(block)) continue;
      if (block.height == 0) return block;
      const std::optional<SearchBlock> found = FirstLeafOutside(Children(block), excluded);
      if (found) return found;
    }
    return std::nullopt;
  }

  /// The 8 x 8 blocks that `parent` is branched into, best first. But for a trace, those that do
  /// not beat the best score are left out.
  std::vector<SearchBlock> Children(const SearchBlock& parent) {
    const int w = window_.num_linear_steps;
    const int side = (1 << parent.height) - 1;
    const CellIndex first = parent.offset;
    const CellIndex last{std::min(first.x + side, w), std::min(first.y + side, w)};
    const SearchSquare square = ScoredSquare(first, last, parent.angle_index,
                                             parent.height - kHeightsPerBranch, parent.trace_index);
    std::vector<SearchBlock> children;
    const int max_sum = square.MaxSum();
    if (trace_ == nullptr && max_sum <= best_sum_) {
      pruned_sum_ = std::max(pruned_sum_, max_sum);
      return children;
    }
    for (int row = 0; row < square.num_rows; ++row) {
      for (int column = 0; column < square.num_columns; ++column) {
        const SearchBlock block = square.BlockAt(row, column);
        if (block.sum <= best_sum_) pruned_sum_ = std::max(pruned_sum_, block.sum);
        if (trace_ != nullptr || block.sum > best_sum_) children.push_back(block);
      }
    }
    std::sort(children.rbegin(), children.rend());
    return children;
  }

  /// The 8 x 8 blocks from `first` on, as far as they begin at `last` or before. `parent` is theirs
  /// in the trace.
  SearchSquare ScoredSquare(CellIndex first, CellIndex last, int angle_index, int height,
                            int parent) {
    SearchSquare square;
    square.first = first;
    square.angle_index = angle_index;
    square.height = height;
    square.num_rows = NumBlocks(first.y, last.y, height);
    square.num_columns = NumBlocks(first.x, last.x, height);
    square.sums = SumBlocks(grids_.at_height(height), CellsAt(angle_index), num_points_, first,
                            square.num_rows);
    if (trace_ != nullptr) square.first_trace_index = AddToTrace(square, parent);
    return square;
  }

  /// Returns the index of the first of the square.
  int AddToTrace(const SearchSquare& square, int parent) {
    const int first = static_cast<int>(trace_->nodes.size());
    for (int row = 0; row < square.num_rows; ++row) {
      for (int column = 0; column < square.num_columns; ++column) {
        const SearchBlock block = square.BlockAt(row, column);
        trace_->nodes.push_back({parent, block.height, block.offset, block.angle_index,
                                 ScoreOf(block.sum), 0.0, SearchFate::kPruned});
      }
    }
    return first;
  }

  /// Along a side of a square from `first` on, as far as they begin at `last` or before.
  static int NumBlocks(int first, int last, int height) {
    return std::min(kBlocksPerSide, ((last - first) >> height) + 1);
  }

  /// One for each point.
  const CellIndex* CellsAt(int angle_index) {
    CellIndex*& cells = cells_at_angle_[angle_index + window_.num_angular_steps];
    if (cells == nullptr) {
      cells = std::pmr::polymorphic_allocator<CellIndex>(&memory_).allocate(num_points_);
      scan_.CellsAt(angle_index, cells);
    }
    return cells;
  }

  /// Where the bounds are highest, without regard to the best score: a fair answer to "how well
  /// would it have matched" for a search that found nothing.
  SearchBlock DescendToLeaf() {
    trace_ = nullptr;
    best_sum_ = -1;
    SearchBlock block = best_start_;
    while (block.height > 0) block = Children(block).front();
    return block;
  }

  void Decide(const SearchBlock& block, SearchFate fate) {
    if (trace_ == nullptr) return;
    SearchNode& node = trace_->nodes[block.trace_index];
    node.fate = fate;
    node.bound = ScoreOf(block.sum);  // if it was refined
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

  SearchResult ResultOf(const SearchBlock& leaf) const {
    return {PoseInWindow(window_, leaf.offset, leaf.angle_index), ScoreOf(leaf.sum)};
  }

  const PrecomputedGrids& grids_;
  const SearchWindow& window_;
  const TurnedScan scan_;
  const int num_points_;
  SearchTrace* trace_;
  std::pmr::monotonic_buffer_resource memory_;  ///< of cells_at_angle_
  std::vector<CellIndex*> cells_at_angle_;      ///< null until they are needed
  int start_height_ = 0;
  std::optional<SectorQueue> sectors_;        ///< whose start nodes have no bounds of their own yet
  StartQueue queue_;                          ///< those that have
  SearchBlock best_start_{{}, 0, 0, -1, -1};  ///< the start node with the highest bound
  int best_sum_ = -1;
  double best_score_ = 0.0;
  double rival_share_ = 1.0;           ///< of the winner's score; those of rivals are higher
  std::vector<SearchBlock> branched_;  ///< start nodes
  int pruned_sum_ = 0;                 ///< the highest bound that was not followed
  std::optional<SearchBlock> winner_;
};

/// Half the side of a square around the centre of `box` that holds it.
double HalfSide(const CellBox& box, double resolution) {
  return 0.5 * resolution * std::max(box.width, box.height);
}

}  // namespace

BranchAndBoundMatcher::BranchAndBoundMatcher(const ProbabilityGrid& grid, int depth)
    : grids_(std::make_unique<PrecomputedGrids>(grid, depth)) {}

BranchAndBoundMatcher::~BranchAndBoundMatcher() = default;

std::size_t BranchAndBoundMatcher::num_bytes() const { return grids_->num_bytes(); }

SearchOutcome BranchAndBoundMatcher::Search(const PointCloud& points_in_scan,
                                            const Pose2& submap_from_scan_guess,
                                            double linear_window, double angular_window,
                                            double min_score, SearchTrace* trace) const {
  assert(!points_in_scan.empty());
  const SearchWindow window = MakeSearchWindow(points_in_scan, submap_from_scan_guess,
                                               linear_window, angular_window, grids_->resolution());
  return loopscope::Search(*grids_, window, points_in_scan, trace).Run(min_score);
}

SearchOutcome BranchAndBoundMatcher::SearchWithRival(const PointCloud& points_in_scan,
                                                     const Pose2& submap_from_scan_guess,
                                                     double linear_window, double angular_window,
                                                     double min_score,
                                                     const RivalCriterion& rival) const {
  assert(!points_in_scan.empty());
  const SearchWindow window = MakeSearchWindow(points_in_scan, submap_from_scan_guess,
                                               linear_window, angular_window, grids_->resolution());
  return loopscope::Search(*grids_, window, points_in_scan, nullptr).RunWithRival(min_score, rival);
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
