// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/matching/search_lattice.h"

namespace loopscope {

namespace {

/// Larger ones ask for matchers less often, but keep the threads waiting for longer.
constexpr std::size_t kBatchSize = 32;

/// Of grids and precomputed grids that are kept: those of some 60 submaps of a building.
constexpr std::size_t kMaxBytes = std::size_t{160} << 20;

SearchOutcome Search(const LoopCandidate& pair, const PointCloud& points_in_node,
                     const BranchAndBoundMatcher& matcher, const LoopAmbiguityOptions& ambiguity) {
  if (pair.whole_submap) return matcher.SearchWholeSubmap(points_in_node, pair.min_score);
  return matcher.SearchWithRival(points_in_node, pair.submap_from_node_guess,
                                 pair.linear_search_window, pair.angular_search_window,
                                 pair.min_score,
                                 {ambiguity.min_distance, ambiguity.max_relative_score});
}

/// A last look asks only for what the submap knows where the map has the node. Along a corridor,
/// where it knows more a scan scores more, and may fit as well where the map has it: that is a
/// rival if it is elsewhere.
std::optional<SearchResult> RivalAtTheGuess(const LoopCandidate& found,
                                            const PointCloud& points_in_node,
                                            const ProbabilityGrid& grid,
                                            const ConstraintBuilderOptions& options) {
  const double max_relative_score = options.ambiguity.max_relative_score;
  if (!found.last_look || max_relative_score >= 1.0) return std::nullopt;
  const Pose2 at_guess =
      RefinedPose(points_in_node, grid, found.submap_from_node_guess, options.ceres_scan_matcher);
  const Pose2& winner = found.submap_from_node;
  const double distance = (at_guess.translation - winner.translation).norm();
  if (distance <= options.ambiguity.min_distance) return std::nullopt;
  const double relative_score =
      RelativeScoreOfKnown(points_in_node, at_guess, winner, grid, options.last_look);
  if (relative_score <= max_relative_score) return std::nullopt;
  return SearchResult{at_guess, relative_score * found.score};
}

bool IsFromBehind(const LoopCandidate& found, const RangeData& scan_in_node,
                  const ProbabilityGrid& grid, const WallSidesOptions& options) {
  return options.max_share_from_behind < 1.0 &&
         FindReturnsOnWalls(scan_in_node, found.submap_from_node, grid).ShareFromBehind() >
             options.max_share_from_behind;
}

Verdict VerdictOnWinner(const LoopCandidate& found, const RangeData& scan_in_node,
                        const ProbabilityGrid& grid, const ConstraintBuilderOptions& options) {
  const bool is_at_border =
      options.ambiguity.refuse_at_border && IsAtBorder(found, grid.resolution());
  if (found.rival_score > 0.0 || is_at_border) return Verdict::kAmbiguous;
  if (IsFromBehind(found, scan_in_node, grid, options.wall_sides)) return Verdict::kFromBehind;
  return Verdict::kAccepted;
}

}  // namespace

LoopCandidate Rounded(LoopCandidate candidate) {
  for (double LoopCandidate::*const number :
       {&LoopCandidate::linear_search_window, &LoopCandidate::angular_search_window,
        &LoopCandidate::score, &LoopCandidate::score_bound, &LoopCandidate::min_score,
        &LoopCandidate::rival_score}) {
    candidate.*number = loopscope::Rounded(candidate.*number);
  }
  for (Pose2 LoopCandidate::*const pose :
       {&LoopCandidate::submap_from_node_guess, &LoopCandidate::submap_from_node_searched,
        &LoopCandidate::submap_from_node}) {
    candidate.*pose = loopscope::Rounded(candidate.*pose);
  }
  return candidate;
}

bool IsAtBorder(const LoopCandidate& found, double resolution) {
  if (found.whole_submap) return false;
  const Eigen::Vector2d moved =
      found.submap_from_node_searched.translation - found.submap_from_node_guess.translation;
  return std::lround(moved.cwiseAbs().maxCoeff() / resolution) >=
         NumLinearSteps(found.linear_search_window, resolution);
}

struct LoopSearch::SearchedSubmap {
  PackedGrid grid;
  double num_considered = 0.0;  ///< pairs, by their sampling shares
  int num_sampled = 0;
};

SearchedLoop SearchLoop(const LoopCandidate& candidate, const RangeData& scan_in_node,
                        const ProbabilityGrid& grid, const BranchAndBoundMatcher& matcher,
                        const ConstraintBuilderOptions& options) {
  const PointCloud& points_in_node = scan_in_node.returns;
  LoopCandidate result = Rounded(candidate);
  const SearchOutcome outcome = Search(result, points_in_node, matcher, options.ambiguity);
  result.score = outcome.best_found.score;
  result.score_bound = outcome.score_bound;
  result.submap_from_node_searched = outcome.best_found.submap_from_scan;
  result.submap_from_node = result.submap_from_node_searched;
  result.verdict = Verdict::kBelowMinScore;
  if (!outcome.winner) return {Rounded(result), std::nullopt};
  result.submap_from_node = RefinedPose(points_in_node, grid, result.submap_from_node_searched,
                                        options.ceres_scan_matcher);
  const std::optional<SearchResult> rival =
      outcome.rival ? outcome.rival : RivalAtTheGuess(result, points_in_node, grid, options);
  if (rival) result.rival_score = rival->score;
  result.verdict = VerdictOnWinner(result, scan_in_node, grid, options);
  return {Rounded(result), rival};
}

Constraint ToConstraint(const LoopCandidate& accepted, const ConstraintBuilderOptions& options) {
  return {accepted.submap,
          accepted.node,
          accepted.submap_from_node,
          options.loop_closure_translation_weight,
          options.loop_closure_rotation_weight,
          Constraint::Tag::kInterSubmap};
}

LoopSearch::LoopSearch(const ConstraintBuilderOptions& options, int num_threads)
    : options_(options),
      matchers_(kMaxBytes, options.fast_correlative_scan_matcher.branch_and_bound_depth),
      pool_(num_threads) {}

LoopSearch::~LoopSearch() = default;

void LoopSearch::AddSubmap(SubmapId id, const ProbabilityGrid& grid) {
  submaps_.emplace(id, std::make_unique<SearchedSubmap>(SearchedSubmap{PackedGrid(grid), 0.0, 0}));
}

void LoopSearch::Consider(const LoopCandidate& candidate,
                          std::shared_ptr<const RangeData> scan_in_node, double sampling_share) {
  if (Sample(sampling_share, submaps_.at(candidate.submap).get())) {
    Begin(candidate, std::move(scan_in_node));
    return;
  }
  LoopCandidate left_out;
  left_out.submap = candidate.submap;
  left_out.node = candidate.node;
  left_out.considered_step = candidate.considered_step;
  pending_.push_back(std::make_unique<LoopCandidate>(left_out));
}

void LoopSearch::Begin(const LoopCandidate& candidate,
                       std::shared_ptr<const RangeData> scan_in_node) {
  pending_.push_back(std::make_unique<LoopCandidate>(candidate));
  BeginInPlace(pending_.back().get(), std::move(scan_in_node));
}

void LoopSearch::BeginInPlace(LoopCandidate* candidate,
                              std::shared_ptr<const RangeData> scan_in_node) {
  std::vector<Pair>& batch = batches_[candidate->submap];
  batch.push_back({candidate, std::move(scan_in_node)});
  if (batch.size() == kBatchSize) HandOver(std::exchange(batch, {}));
}

void LoopSearch::HandOver(std::vector<Pair> batch) {
  if (batch.empty()) return;
  const SubmapId id = batch.front().candidate->submap;
  const PackedGrid* const grid = &submaps_.at(id)->grid;
  pool_.Add([this, id, grid, pairs = std::move(batch)] {
    const auto searchable = matchers_.SearchableOf(id, *grid);
    for (const Pair& pair : pairs) {
      LoopCandidate asked = *pair.candidate;
      if (asked.last_look) {
        asked.min_score =
            MinScoreOfLastLook(asked.min_score, pair.scan_in_node->returns,
                               asked.submap_from_node_guess, searchable->grid, options_.last_look);
      }
      *pair.candidate =
          SearchLoop(asked, *pair.scan_in_node, searchable->grid, searchable->matcher, options_)
              .candidate;
    }
    matchers_.Trim();
  });
}

void LoopSearch::Wait() {
  for (auto& [submap, batch] : std::exchange(batches_, {})) HandOver(std::move(batch));
  pool_.Wait();
}

std::vector<LoopCandidate> LoopSearch::Collect() {
  Wait();
  std::vector<LoopCandidate> candidates;
  candidates.reserve(pending_.size());
  for (const auto& candidate : std::exchange(pending_, {})) candidates.push_back(*candidate);
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const LoopCandidate& a, const LoopCandidate& b) {
        return std::pair(a.submap.index, a.node.index) < std::pair(b.submap.index, b.node.index);
      });
  return candidates;
}

bool LoopSearch::Sample(double sampling_share, SearchedSubmap* submap) const {
  submap->num_considered += sampling_share;
  if (submap->num_sampled >= options_.sampling_ratio * submap->num_considered) return false;
  ++submap->num_sampled;
  return true;
}

}  // namespace loopscope
