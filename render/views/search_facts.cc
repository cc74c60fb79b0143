// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/search_facts.h"

#include <fmt/format.h>

#include "core/graph/last_look.h"
#include "core/graph/loop_consistency.h"
#include "core/matching/search_lattice.h"
#include "core/slam/loop_explanation.h"
#include "render/number_text.h"

namespace loopscope {
namespace {

std::string VerdictText(const SearchReplay& search) {
  if (search.recorded) return ToString(search.candidate.verdict);
  // A replay is the search alone: other loops have no say in it.
  return search.result.verdict == Verdict::kAccepted ? "would match"
                                                     : ToString(search.result.verdict);
}

/// How far the search, and then the refinement by (CS), moved the node.
std::vector<Fact> MovesOf(const SearchReplay& search) {
  const LoopCandidate& result = search.result;
  const Pose2 moved = Moved(result);
  std::vector<Fact> facts{{"moved", LengthText(moved.translation.norm())},
                          {"turned left", AngleText(moved.rotation)}};
  if (search.trace.winner < 0) return facts;
  const Pose2 refined = result.submap_from_node_searched.Inverse() * result.submap_from_node;
  facts.push_back({"refined by", LengthText(refined.translation.norm())});
  return facts;
}

/// What would refuse the winner, and what is allowed of it.
std::vector<Fact> ChecksOf(const SearchReplay& search, const ConstraintBuilderOptions& options) {
  const LoopCandidate& result = search.result;
  std::vector<Fact> facts;
  if (result.rival_score > 0.0) {
    facts.push_back(
        {"rival score", fmt::format("{:.3f}, at most {:.3f}", result.rival_score,
                                    options.ambiguity.max_relative_score * result.score)});
  }
  if (result.verdict == Verdict::kAmbiguous && result.rival_score == 0.0) {
    facts.push_back({"winner", "at the window's border"});
  }
  if (result.verdict == Verdict::kFromBehind) {
    facts.push_back({"from behind", fmt::format("{:.0f} %, at most {:.0f} %",
                                                100.0 * WallsOf(search).ShareFromBehind(),
                                                100.0 * options.wall_sides.max_share_from_behind)});
  }
  const bool was_compared =
      search.recorded && result.verdict == Verdict::kAccepted && !search.candidate.last_look;
  if (was_compared && options.consistency.min_num_supporters > 0) {
    facts.push_back(
        {"nodes that agree", fmt::format("{}, at least {}", search.candidate.num_supporters,
                                         MinNumSupporters(search.candidate, options.consistency))});
  }
  if (search.recorded && search.candidate.last_look) {
    facts.push_back(
        {"off the map", LengthText(ResidualAtGuess(search.candidate).head<2>().norm())});
  }
  return facts;
}

/// What came of the search.
std::vector<Fact> OutcomeOf(const SearchReplay& search, const ConstraintBuilderOptions& options) {
  const LoopCandidate& result = search.result;
  std::vector<Fact> facts{
      {"verdict", VerdictText(search)},
      {IsFound(result.verdict) ? "best score" : "best seen", fmt::format("{:.3f}", result.score)},
      {"min_score", fmt::format("{:.3f}", result.min_score)},
      {"no pose above", fmt::format("{:.3f}", result.score_bound)}};
  for (const Fact& fact : ChecksOf(search, options)) facts.push_back(fact);
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

ReturnsOnWalls WallsOf(const SearchReplay& search) {
  return FindReturnsOnWalls(search.scan, search.result.submap_from_node, search.grid);
}

std::vector<Fact> FactsOf(const SearchReplay& search, const SearchPart& part,
                          const ConstraintBuilderOptions& options) {
  const SearchWindow& window = search.trace.window;
  const double num_poses = NumPoses(window);
  const std::size_t num_scored = search.trace.nodes.size();
  const bool whole = !part.filter().num_visits;
  std::vector<Fact> facts = whole ? OutcomeOf(search, options) : ProgressOf(search, part);
  facts.push_back({"window", fmt::format("±{:.2f} m, ±{:.1f}°", search.result.linear_search_window,
                                         RadiansToDegrees(search.result.angular_search_window))});
  facts.push_back({"poses in it", CountText(num_poses)});
  if (!whole) return facts;
  facts.push_back(
      {"nodes scored", fmt::format("{} ({:.2g} %)", num_scored, 100.0 * num_scored / num_poses)});
  return facts;
}

}  // namespace loopscope
