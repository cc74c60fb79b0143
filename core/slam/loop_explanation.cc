// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/loop_explanation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/graph/drift_share.h"
#include "core/graph/last_look.h"
#include "core/graph/loop_search.h"
#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

/// Every place that can be scored scores more.
constexpr double kAnyScore = kMinProbability;

/// The pair must be one that can be searched.
LoopCandidate BestInWindow(const Recording& recording, SubmapId submap, NodeId node) {
  return SearchPair(recording, submap, node, kAnyScore).value();
}

/// "the best place scores 0.512, 0.34 m and 1.2 deg from the estimate".
std::string PlaceText(const LoopCandidate& best) {
  if (!IsFound(best.verdict)) return "no place touches what the submap knows";
  const Pose2 moved = Moved(best);
  return fmt::format("the best place scores {:.3f}, {:.2f} m and {:.1f} deg from the estimate",
                     best.score, moved.translation.norm(),
                     RadiansToDegrees(std::abs(NormalizeAngle(moved.rotation))));
}

std::string ResidualText(const Eigen::Vector3d& residual) {
  return fmt::format("{:.3f} m, {:.2f} deg", residual.head<2>().norm(),
                     RadiansToDegrees(std::abs(residual.z())));
}

/// Collects checks until one fails.
class Checklist {
 public:
  /// Whether to go on.
  bool Add(LoopCheck check, const std::string& answer_if_failed) {
    explanation_.checks.push_back(std::move(check));
    if (!explanation_.checks.back().passed) explanation_.answer = answer_if_failed;
    return explanation_.checks.back().passed;
  }

  /// Likewise, of what hardly any pair fails, so that it is listed only then.
  bool AddIfFailed(LoopCheck check, const std::string& answer_if_failed) {
    return check.passed || Add(std::move(check), answer_if_failed);
  }

  /// The answer goes on with what is there in the window.
  LoopExplanation NothingFound(const LoopCandidate& best_in_window, double min_score) {
    explanation_.best_in_window = best_in_window;
    explanation_.answer += fmt::format(
        " Within {:.2f} m and {:.1f} deg {}; more than {:.3f} is needed.",
        best_in_window.linear_search_window, RadiansToDegrees(best_in_window.angular_search_window),
        PlaceText(best_in_window), min_score);
    return explanation_;
  }

  LoopExplanation Closed(const std::string& answer) {
    explanation_.closed = true;
    explanation_.answer = answer;
    return explanation_;
  }

  LoopExplanation explanation() const { return explanation_; }

 private:
  LoopExplanation explanation_;
};

LoopCheck FinishedCheck(const Submap& submap) {
  const bool finished = submap.finished_step >= 0;
  return {"submap finished", finished ? fmt::format("at scan {}", submap.finished_step) : "no",
          "yes", finished};
}

LoopCheck OutsideCheck(const Submap& submap, bool node_lies_in) {
  return {"node outside of submap",
          fmt::format("submap has nodes {} to {}", submap.first_node.index,
                      submap.first_node.index + submap.num_nodes - 1),
          "not among them", !node_lies_in};
}

LoopCheck DistanceCheck(const LoopGate& gate, const ConstraintBuilderOptions& options) {
  const double growth =
      gate.linear_window - options.fast_correlative_scan_matcher.linear_search_window;
  std::string most = fmt::format("at most {:.2f} m", options.max_constraint_distance);
  if (gate.way > 0.0) {
    most = fmt::format("at most {:.2f} m, {:.1f} m and {:.2f} m for drift over {:.0f} m of way",
                       options.max_constraint_distance + growth, options.max_constraint_distance,
                       growth, gate.way);
  }
  return {"distance to the submap's nodes", fmt::format("{:.2f} m", gate.distance), most,
          gate.is_near};
}

LoopCheck SearchesCheck(const PoseGraphOptions& options) {
  return {"optimize_every_n_nodes", std::to_string(options.optimize_every_n_nodes), "at least 1",
          options.optimize_every_n_nodes > 0};
}

LoopCheck PointsCheck(const Recording& recording, NodeId node) {
  const std::size_t num_points = LoopScanOfNode(recording, node).returns.size();
  return {"points to search with", std::to_string(num_points), "at least 1", num_points > 0};
}

/// Whether the pair got its turn before the recording ended. Those that did are recorded.
LoopCheck TurnCheck(const Recording& recording, const LoopCandidate* candidate) {
  return {"came up before the end",
          candidate != nullptr ? "yes" : fmt::format("no: {} scans", recording.num_steps()), "yes",
          candidate != nullptr};
}

LoopCheck SampledCheck(const LoopCandidate& candidate, const ConstraintBuilderOptions& options) {
  const bool searched = candidate.verdict != Verdict::kNotSampled;
  return {"sampled", searched ? "yes" : "no",
          fmt::format("a share of {} of the pairs at most{}", options.sampling_ratio,
                      options.second_look.num_nodes > 0 ? ", or a second look" : ""),
          searched};
}

/// Why the search took another window than the way allows; nothing if it did not.
std::optional<LoopCheck> WindowCheck(const Recording& recording, const LoopCandidate& candidate,
                                     const LoopGate& gate) {
  const std::string window = fmt::format("{:.2f} m, {:.1f} deg", candidate.linear_search_window,
                                         RadiansToDegrees(candidate.angular_search_window));
  if (candidate.submap_from_node_guess !=
      GuessOfPair(recording, candidate.submap, candidate.node)) {
    return LoopCheck{"search window",
                     window + " around where a loop of a node nearby has it, to check that", "",
                     true};
  }
  const double linear = ShareOfWindow(candidate.linear_search_window, gate.linear_window);
  const double angular = ShareOfWindow(candidate.angular_search_window, gate.angular_window);
  constexpr double kRounding = 1e-3;
  if (linear > 1.0 - kRounding && angular > 1.0 - kRounding) return std::nullopt;
  return LoopCheck{
      "search window",
      fmt::format("{}: {:.0f} % and {:.0f} % of what the way allows, as loops before were off by "
                  "less",
                  window, 100.0 * linear, 100.0 * angular),
      "", true};
}

/// What a score had to beat, and where that comes from.
std::string NeededText(const LoopCandidate& candidate, const ConstraintBuilderOptions& options) {
  std::string text = fmt::format("more than {:.3f}", candidate.min_score);
  if (candidate.last_look) {
    text += fmt::format(", {} of what else is asked, in a last look, of what the submap knows",
                        options.last_look.min_score_factor);
  } else if (candidate.min_score > options.min_score) {
    text += fmt::format(", {} of what its own scans score", options.min_relative_score);
  }
  return text;
}

/// `score` is the best in the window.
LoopCheck ScoreCheck(const LoopCandidate& candidate, double score,
                     const ConstraintBuilderOptions& options) {
  return {"score",
          fmt::format("{:.3f} in a window of {:.2f} m, {:.1f} deg", score,
                      candidate.linear_search_window,
                      RadiansToDegrees(candidate.angular_search_window)),
          NeededText(candidate, options), candidate.verdict != Verdict::kBelowMinScore};
}

LoopCheck AmbiguityCheck(const LoopCandidate& candidate, const LoopAmbiguityOptions& options) {
  const std::string rival = candidate.rival_score > 0.0
                                ? fmt::format("one scores {:.3f}", candidate.rival_score)
                                : "none";
  return {fmt::format("rivals {} m away or more", options.min_distance), rival,
          fmt::format("none above {:.3f}", options.max_relative_score * candidate.score),
          candidate.rival_score == 0.0};
}

LoopCheck BorderCheck(const Recording& recording, const LoopCandidate& candidate) {
  const bool at_border =
      IsAtBorder(candidate, recording.options().trajectory_builder_2d.submaps.grid_resolution);
  return {"winner at the border of the window", at_border ? "yes" : "no",
          recording.options().pose_graph.constraint_builder.ambiguity.refuse_at_border ? "no" : "",
          candidate.verdict != Verdict::kAmbiguous};
}

LoopCheck WallSidesCheck(const Recording& recording, const LoopCandidate& candidate,
                         const WallSidesOptions& options) {
  const double share =
      FindReturnsOnWalls(LoopScanOfNode(recording, candidate.node), candidate.submap_from_node,
                         GridOfSubmap(recording, candidate.submap))
          .ShareFromBehind();
  return {"returns on walls that the submap knows from the other side only",
          fmt::format("{:.0f} %", 100.0 * share),
          fmt::format("at most {:.0f} %", 100.0 * options.max_share_from_behind),
          candidate.verdict != Verdict::kFromBehind};
}

/// How far from the map a loop may be; empty if that is up to it.
std::string MostOff(const OutlierOptions& options) {
  if (options.max_distance <= 0.0) return "";
  return fmt::format("at most {} m, {:.2f} deg", options.max_distance,
                     RadiansToDegrees(options.max_angle));
}

LoopCheck ConsistencyCheck(const LoopCandidate& candidate, const PoseGraphOptions& options) {
  const bool is_consistent = candidate.verdict != Verdict::kInconsistent;
  if (candidate.last_look) {
    return {"off the optimized map", ResidualText(ResidualAtGuess(candidate)),
            MostOff(options.optimization_problem.outliers), is_consistent};
  }
  return {"other nodes with loops that agree", std::to_string(candidate.num_supporters),
          fmt::format("at least {}",
                      MinNumSupporters(candidate, options.constraint_builder.consistency)),
          is_consistent};
}

std::string InconsistentAnswer(const LoopCandidate& candidate) {
  return candidate.last_look
             ? "Not closed: it matched, but too far from where the optimized map has it."
             : "Not closed: it matched, but too few loops of other nodes say the same.";
}

LoopCheck ResidualCheck(const Recording& recording, const LoopCandidate& candidate) {
  const OutlierOptions& outliers = recording.options().pose_graph.optimization_problem.outliers;
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  const Eigen::Vector3d residual = LoopResidual(state, candidate);
  return {"residual at the end", ResidualText(residual), MostOff(outliers),
          !IsOutlier(residual, outliers)};
}

}  // namespace

LoopExplanation ExplainLoop(const Recording& recording, SubmapId submap, NodeId node) {
  const ConstraintBuilderOptions& options = recording.options().pose_graph.constraint_builder;
  const Submap& record = recording.submap(submap);
  Checklist list;
  if (!list.Add(
          FinishedCheck(record),
          "Not closed: the submap was never finished, and only finished ones are searched.") ||
      !list.Add(OutsideCheck(record, recording.node(node).LiesIn(submap)),
                "Not closed: the node was inserted into the submap itself (INTRA_SUBMAP).") ||
      !list.AddIfFailed(SearchesCheck(recording.options().pose_graph),
                        "Not closed: loops were not searched at all.") ||
      !list.AddIfFailed(PointsCheck(recording, node),
                        "Not closed: the scan has nothing to match.")) {
    return list.explanation();
  }
  const LoopGate gate = GateOfPair(recording, submap, node);
  const std::optional<int> index = recording.FindCandidate(submap, node);
  const LoopCandidate* const candidate = index ? &recording.candidates()[*index] : nullptr;
  if (!list.Add(DistanceCheck(gate, options), "Not closed: too far apart to be searched.") ||
      !list.AddIfFailed(TurnCheck(recording, candidate),
                        "Not closed: the recording ends before its loops were searched.") ||
      !list.Add(SampledCheck(*candidate, options),
                "Not closed: the pair was near enough, but skipped by sampling_ratio.")) {
    return list.NothingFound(BestInWindow(recording, submap, node),
                             ConsiderPair(recording, submap, node).min_score);
  }
  if (const auto window = WindowCheck(recording, *candidate, gate)) list.Add(*window, "");
  if (candidate->verdict == Verdict::kBelowMinScore) {
    const LoopCandidate best = BestInWindow(recording, submap, node);
    list.Add(ScoreCheck(*candidate, best.score, options),
             "Not closed: nothing in the window matches well enough.");
    return list.NothingFound(best, candidate->min_score);
  }
  list.Add(ScoreCheck(*candidate, candidate->score, options), "");
  if (!list.Add(AmbiguityCheck(*candidate, options.ambiguity),
                "Not closed: the scan fits at other places nearly as well.") ||
      !list.Add(BorderCheck(recording, *candidate),
                "Not closed: a place beyond the window may match better.") ||
      !list.Add(WallSidesCheck(recording, *candidate, options.wall_sides),
                "Not closed: it lies on the wrong side of walls.") ||
      !list.Add(ConsistencyCheck(*candidate, recording.options().pose_graph),
                InconsistentAnswer(*candidate))) {
    return list.explanation();
  }
  if (!list.Add(ResidualCheck(recording, *candidate),
                fmt::format("Left out at the end: closed at scan {}, but the others contradict it.",
                            candidate->applied_step))) {
    return list.explanation();
  }
  return list.Closed(fmt::format("Closed: in the graph since scan {}.", candidate->applied_step));
}

std::string ExplainWholeSubmap(const Recording& recording, const LoopCandidate& best_in_window) {
  const LoopCandidate best =
      SearchWholeSubmap(recording, best_in_window.submap, best_in_window.node, kAnyScore).value();
  if (best.score <= best_in_window.score) return "Nowhere in the submap it scores more.";
  return fmt::format("Anywhere in the submap {}.", PlaceText(best));
}

Eigen::Vector3d LoopResidual(const MapState& state, const LoopCandidate& accepted) {
  return SpaError(accepted.submap_from_node, state.global_from_submap[accepted.submap.index],
                  state.global_from_node[accepted.node.index]);
}

std::string ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kTooFar:
      return "too far";
    case Verdict::kNotSampled:
      return "not sampled";
    case Verdict::kBelowMinScore:
      return "below score";
    case Verdict::kAmbiguous:
      return "ambiguous";
    case Verdict::kFromBehind:
      return "from behind";
    case Verdict::kInconsistent:
      return "inconsistent";
    case Verdict::kAccepted:
      return "closed";
  }
  return "";
}

std::string ReasonOf(const LoopCandidate& candidate) {
  switch (candidate.verdict) {
    case Verdict::kTooFar:
      return "too far apart to be searched";
    case Verdict::kNotSampled:
      return "skipped by sampling_ratio";
    case Verdict::kBelowMinScore:
      return "nothing in the window matches well enough";
    case Verdict::kAmbiguous:
      return candidate.rival_score > 0.0 ? "the scan fits at another place nearly as well"
                                         : "a place beyond the window may match better";
    case Verdict::kFromBehind:
      return "it lies on walls that the submap knows from the other side only";
    case Verdict::kInconsistent:
      return candidate.last_look ? "too far from where the optimized map has it"
                                 : "too few loops of other nodes say the same";
    case Verdict::kAccepted:
      return "passed every gate";
  }
  return "";
}

std::vector<std::string> VerdictSummary(const std::vector<LoopCandidate>& candidates) {
  std::vector<std::string> counts;
  for (const Verdict verdict : kRecordedVerdicts) {
    const auto has_verdict = [verdict](const LoopCandidate& c) { return c.verdict == verdict; };
    const auto count = std::count_if(candidates.begin(), candidates.end(), has_verdict);
    counts.push_back(fmt::format("{} {}", count, ToString(verdict)));
  }
  return counts;
}

}  // namespace loopscope
