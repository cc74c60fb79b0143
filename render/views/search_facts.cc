// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/search_facts.h"

#include <fmt/format.h>

#include "core/matching/search_lattice.h"
#include "render/number_text.h"

namespace loopscope {
namespace {

std::string VerdictText(const SearchReplay& search) {
  // The replay is the search alone: what other loops say of it is in the recording.
  const Verdict verdict = search.recorded ? search.candidate.verdict : search.result.verdict;
  switch (verdict) {
    case Verdict::kTooFar:
      return "too far apart";
    case Verdict::kNotSampled:
      return "not sampled";
    case Verdict::kBelowMinScore:
      return "below min_score";
    case Verdict::kAmbiguous:
      return "fits elsewhere as well";
    case Verdict::kFromBehind:
      return "on walls from behind";
    case Verdict::kInconsistent:
      return "no other loop agrees";
    case Verdict::kAccepted:
      break;
  }
  return search.recorded ? "closed" : "matches";
}

/// How far the search, and then the refinement by (CS), moved the node.
std::vector<Fact> MovesOf(const SearchReplay& search) {
  const LoopCandidate& result = search.result;
  const Pose2 moved =
      search.candidate.submap_from_node_guess.Inverse() * result.submap_from_node_searched;
  std::vector<Fact> facts{{"moved", LengthText(moved.translation.norm())},
                          {"turned left", AngleText(moved.rotation)}};
  if (search.trace.winner < 0) return facts;
  const Pose2 refined = result.submap_from_node_searched.Inverse() * result.submap_from_node;
  facts.push_back({"refined by", LengthText(refined.translation.norm())});
  return facts;
}

/// What came of the search.
std::vector<Fact> OutcomeOf(const SearchReplay& search) {
  const LoopCandidate& result = search.result;
  std::vector<Fact> facts{{"verdict", VerdictText(search)},
                          {"best score", fmt::format("{:.3f}", result.score)},
                          {"no pose above", fmt::format("{:.3f}", result.score_bound)},
                          {"min_score", fmt::format("{:.3f}", result.min_score)}};
  if (result.rival_score > 0.0) {
    facts.push_back({"rival score", fmt::format("{:.3f}", result.rival_score)});
  }
  facts.push_back({"nodes that agree", fmt::format("{}", search.candidate.num_supporters)});
  for (const Fact& fact : MovesOf(search)) facts.push_back(fact);
  return facts;
}

/// How far the search had come.
std::vector<Fact> ProgressOf(const SearchReplay& search, const SearchPart& part) {
  const int best = part.best_leaf();
  return {{"after", fmt::format("{} of {} visits", part.num_visits(), search.trace.visits.size())},
          {"scored", fmt::format("{}", part.num_scored())},
          {"expanded", fmt::format("{}", part.num_expanded())},
          {"pruned by bound", fmt::format("{}", part.num_pruned())},
          {"best score so far",
           best < 0 ? "none yet" : fmt::format("{:.3f}", search.trace.nodes[best].bound)},
          {"min_score", fmt::format("{:.3f}", search.result.min_score)}};
}

}  // namespace

std::vector<Fact> FactsOf(const SearchReplay& search, const SearchPart& part) {
  const SearchWindow& window = search.trace.window;
  const double num_poses = NumPoses(window);
  const std::size_t num_scored = search.trace.nodes.size();
  const bool whole = !part.filter().num_visits;
  std::vector<Fact> facts = whole ? OutcomeOf(search) : ProgressOf(search, part);
  facts.push_back(
      {"window", fmt::format("±{:.2f} m, ±{:.0f}°", window.num_linear_steps * window.resolution,
                             RadiansToDegrees(window.num_angular_steps * window.angular_step))});
  facts.push_back({"poses in it", CountText(num_poses)});
  if (!whole) return facts;
  facts.push_back(
      {"nodes scored", fmt::format("{} ({:.2g} %)", num_scored, 100.0 * num_scored / num_poses)});
  return facts;
}

}  // namespace loopscope
