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

/// Of a pose far from the one found that scores nearly as well; 0 if there is none.
double RivalScore(const LoopCandidate& found, const PointCloud& points_in_node,
                  const BranchAndBoundMatcher& matcher, const LoopAmbiguityOptions& options) {
  if (options.max_relative_score >= 1.0 || found.whole_submap) return 0.0;
  const auto rival =
      matcher.FindRival(points_in_node, found.submap_from_node_guess, found.linear_search_window,
                        found.angular_search_window, found.submap_from_node_searched,
                        options.min_distance, options.max_relative_score * found.score);
  return rival ? rival->score : 0.0;
}

bool IsFromBehind(const LoopCandidate& found, const RangeData& scan_in_node,
                  const ProbabilityGrid& grid, const WallSidesOptions& options) {
  return options.max_share_from_behind < 1.0 &&
         ShareFromBehind(scan_in_node, found.submap_from_node, grid) >
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

LoopCandidate SearchLoop(const LoopCandidate& candidate, const RangeData& scan_in_node,
                         const ProbabilityGrid& grid, const BranchAndBoundMatcher& matcher,
                         const ConstraintBuilderOptions& options, SearchTrace* trace) {
  const PointCloud& points_in_node = scan_in_node.returns;
  LoopCandidate result = Rounded(candidate);
  const SearchOutcome outcome =
      result.whole_submap ? matcher.SearchWholeSubmap(points_in_node, result.min_score, trace)
                          : matcher.Search(points_in_node, result.submap_from_node_guess,
                                           result.linear_search_window,
                                           result.angular_search_window, result.min_score, trace);
  result.score = outcome.best_found.score;
  result.score_bound = outcome.score_bound;
  result.submap_from_node_searched = outcome.best_found.submap_from_scan;
  result.submap_from_node = result.submap_from_node_searched;
  result.verdict = Verdict::kBelowMinScore;
  if (!outcome.winner) return Rounded(result);
  result.rival_score = RivalScore(result, points_in_node, matcher, options.ambiguity);
  result.submap_from_node =
      MatchWithCeres(points_in_node, grid, result.submap_from_node_searched.translation,
                     result.submap_from_node_searched, options.ceres_scan_matcher)
          .submap_from_scan;
  result.verdict = VerdictOnWinner(result, scan_in_node, grid, options);
  return Rounded(result);
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
          SearchLoop(asked, *pair.scan_in_node, searchable->grid, searchable->matcher, options_);
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
