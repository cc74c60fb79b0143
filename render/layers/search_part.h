// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/matching/search_trace.h"
#include "render/search_filter.h"

namespace loopscope {

/// What passes a filter of a search: the tree as it was after some of the visits, at one angle or
/// at all. Nodes are indices into SearchTrace::nodes.
class SearchPart {
 public:
  /// Keeps a reference to `trace`. Throws std::invalid_argument that says what was expected if the
  /// search does not have what the filter asks for.
  explicit SearchPart(const SearchTrace& trace, const SearchFilter& filter = {});

  const SearchTrace& trace() const { return trace_; }
  const SearchFilter& filter() const { return filter_; }
  int num_visits() const { return num_visits_; }

  /// Those before it had been scored, at any angle: nodes stand in the order of scoring.
  int num_scored() const { return num_scored_; }
  /// How many had been expanded, or had become the best so far, and how many pruned, at any angle.
  int num_expanded() const { return num_expanded_; }
  int num_pruned() const { return num_visits_ - num_expanded_; }

  /// Whether `node` had been scored and is of the angle asked for.
  bool Shows(int node) const;
  bool WasDecided(int node) const { return visit_of_[node] < num_visits_; }
  bool WasExpanded(int node) const {
    return WasDecided(node) && trace_.nodes[node].fate != SearchFate::kPruned;
  }
  bool WasPruned(int node) const { return WasDecided(node) && !WasExpanded(node); }

  /// The node decided last, if the filter asks for some of the visits; else -1.
  int last() const;
  /// The best leaf so far; -1 if there is none.
  int best_leaf() const { return best_leaf_; }

 private:
  void Require() const;

  const SearchTrace& trace_;
  SearchFilter filter_;
  int num_visits_ = 0;
  int num_scored_ = 0;
  int num_expanded_ = 0;
  int best_leaf_ = -1;
  std::vector<int> visit_of_;  // place in SearchTrace::visits, by node
};

}  // namespace loopscope
