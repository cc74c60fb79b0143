// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/search_part.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace loopscope {
namespace {

void RequireIn(const std::string& what, int value, int min, int max) {
  if (value >= min && value <= max) return;
  throw std::invalid_argument(
      fmt::format("{} {} of the search: expected {} to {}", what, value, min, max));
}

int RootHeight(const SearchTrace& trace) {
  return trace.nodes.empty() ? 0 : trace.nodes.front().height;
}

}  // namespace

SearchPart::SearchPart(const SearchTrace& trace, const SearchFilter& filter)
    : trace_(trace),
      filter_(filter),
      num_visits_(filter.num_visits.value_or(static_cast<int>(trace.visits.size()))),
      visit_of_(trace.nodes.size(), static_cast<int>(trace.visits.size())) {
  Require();
  for (std::size_t i = 0; i < trace.visits.size(); ++i) {
    visit_of_[trace.visits[i]] = static_cast<int>(i);
  }
  for (int i = 0; i < num_visits_; ++i) {
    const SearchFate fate = trace.nodes[trace.visits[i]].fate;
    num_expanded_ += fate != SearchFate::kPruned;
    if (fate == SearchFate::kImproved) best_leaf_ = trace.visits[i];
  }
  const auto first_later = std::find_if(
      trace.nodes.begin(), trace.nodes.end(),
      [&](const SearchNode& node) { return node.parent >= 0 && !WasDecided(node.parent); });
  num_scored_ = static_cast<int>(first_later - trace.nodes.begin());
}

void SearchPart::Require() const {
  const SearchWindow& window = trace_.window;
  RequireIn("visits", num_visits_, 0, static_cast<int>(trace_.visits.size()));
  if (filter_.height) RequireIn("height", *filter_.height, 0, RootHeight(trace_));
  if (filter_.angle_index) {
    RequireIn("angle index", *filter_.angle_index, -window.num_angular_steps,
              window.num_angular_steps);
  }
}

bool SearchPart::Shows(int node) const {
  if (node < 0 || node >= num_scored_) return false;
  return !filter_.angle_index || *filter_.angle_index == trace_.nodes[node].angle_index;
}

int SearchPart::last() const {
  return filter_.num_visits && num_visits_ > 0 ? trace_.visits[num_visits_ - 1] : -1;
}

}  // namespace loopscope
