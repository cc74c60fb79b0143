// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/graph/constraint.h"
#include "core/graph/loop_candidate.h"
#include "core/graph/matcher_cache.h"
#include "core/graph/pose_graph_options.h"
#include "core/graph/task_pool.h"
#include "core/grid/probability_grid.h"
#include "core/matching/branch_and_bound.h"

namespace loopscope {

/// All numbers and poses rounded, as they are searched and recorded.
LoopCandidate Rounded(LoopCandidate candidate);

/// What came of the search of a pair.
struct SearchedLoop {
  LoopCandidate candidate;            ///< Rounded, with verdict, scores and poses
  std::optional<SearchResult> rival;  ///< of candidate.rival_score
};

/// Searches one pair: branch and bound in the window around candidate.submap_from_node_guess (or
/// the whole submap), and (CS) from the winner. Of `scan_in_node` only origin and returns count.
SearchedLoop SearchLoop(const LoopCandidate& candidate, const RangeData& scan_in_node,
                        const ProbabilityGrid& grid, const BranchAndBoundMatcher& matcher,
                        const ConstraintBuilderOptions& options);

/// Whether the winner lies in the outermost cells of its window, so that one beyond could match
/// better. `resolution` [m] is that of the search.
bool IsAtBorder(const LoopCandidate& found, double resolution);

/// The INTER_SUBMAP constraint that an accepted candidate is.
Constraint ToConstraint(const LoopCandidate& accepted, const ConstraintBuilderOptions& options);

/// Searches loops on background threads. What it finds depends on what it is asked, in what order,
/// and on nothing else.
class LoopSearch {
 public:
  LoopSearch(const ConstraintBuilderOptions& options, int num_threads);
  ~LoopSearch();

  /// Makes a finished submap known.
  void AddSubmap(SubmapId id, const ProbabilityGrid& grid);

  /// Begins a search of the pair of `candidate`, if it is its turn by sampling_ratio, for which it
  /// counts as `sampling_share` of a pair. Collect gives it back, searched or not.
  void Consider(const LoopCandidate& candidate, std::shared_ptr<const RangeData> scan_in_node,
                double sampling_share = 1.0);

  /// Begins a search of the pair of `candidate`, whose result Collect gives.
  void Begin(const LoopCandidate& candidate, std::shared_ptr<const RangeData> scan_in_node);

  /// Begins a search of the pair of `candidate`, which is the result after Wait. Its address must
  /// last until then.
  void BeginInPlace(LoopCandidate* candidate, std::shared_ptr<const RangeData> scan_in_node);
  void Wait();

  /// Waits for the searches; the candidates considered since the last call, by submap and node.
  std::vector<LoopCandidate> Collect();

 private:
  struct SearchedSubmap;
  struct Pair {
    LoopCandidate* candidate;
    std::shared_ptr<const RangeData> scan_in_node;
  };

  /// Hands searches in one submap to a thread.
  void HandOver(std::vector<Pair> batch);

  /// Whether it is the turn of a pair with `submap`: a share sampling_ratio of the pairs says so.
  bool Sample(double sampling_share, SearchedSubmap* submap) const;

  ConstraintBuilderOptions options_;
  std::map<SubmapId, std::unique_ptr<SearchedSubmap>> submaps_;
  std::vector<std::unique_ptr<LoopCandidate>> pending_;
  /// Searches that wait for more in the same submap, so that its precomputed grids serve them all.
  std::map<SubmapId, std::vector<Pair>> batches_;
  MatcherCache matchers_;
  TaskPool pool_;
};

}  // namespace loopscope
