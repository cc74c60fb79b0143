// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/scan_matching.h"

#include <algorithm>
#include <cmath>

#include "core/matching/branch_and_bound.h"
#include "core/matching/match_score.h"
#include "core/matching/prior_search.h"

namespace loopscope {
namespace {

/// Enough for windows of a few metres.
constexpr int kRecoveryDepth = 5;

ScanMatch MatchNear(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                    const Pose2& submap_from_base_prior, const LocalSlamOptions& options) {
  ScanMatch match;
  Pose2 start = submap_from_base_prior;
  if (options.use_online_correlative_scan_matching) {
    start = MatchCorrelative(points_in_base, grid, submap_from_base_prior,
                             options.real_time_correlative_scan_matcher)
                .submap_from_scan;
    match.submap_from_base_correlative = start;
  }
  match.submap_from_base = RefineScanMatch(points_in_base, grid, submap_from_base_prior.translation,
                                           start, options.ceres_scan_matcher)
                               .submap_from_scan;
  match.score = MeanProbability(points_in_base, match.submap_from_base, grid);
  return match;
}

/// `options` for a prior that nobody measured: the robot may have sped up or turned meanwhile.
LocalSlamOptions Loosened(LocalSlamOptions options) {
  const double scale = options.unmeasured_prior_scale;
  CorrelativeScanMatcherOptions& correlative = options.real_time_correlative_scan_matcher;
  correlative.linear_search_window *= scale;
  correlative.angular_search_window *= scale;
  correlative.translation_delta_cost_weight /= scale;
  correlative.rotation_delta_cost_weight /= scale;
  options.ceres_scan_matcher.translation_weight /= scale;
  options.ceres_scan_matcher.rotation_weight /= scale;
  return options;
}

/// `options` for a prior that was measured. The less a robot moves between two scans, the less
/// odometry can be wrong; but the second is pulled to the cells that the first one hit all the
/// same, so that along a corridor the robot lags behind more, the more scans there are.
LocalSlamOptions Stiffened(LocalSlamOptions options, double motion_size) {
  constexpr double kMaxScale = 2.5;  // a robot may slip
  const double full_size = options.full_prior_motion;
  if (full_size > 0.0) {
    options.ceres_scan_matcher.translation_weight *=
        std::clamp(full_size / motion_size, 1.0, kMaxScale);
  }
  return options;
}

/// Where odometry has it, or where the velocity does, see second_prior_relative_score.
ScanMatch MatchAroundPriors(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                            const MatchPrior& prior, double expected_score,
                            const LocalSlamOptions& options) {
  const ScanMatch match =
      MatchNear(points_in_base, grid, prior.submap_from_base,
                prior.is_measured ? Stiffened(options, prior.motion_size) : Loosened(options));
  if (!prior.submap_from_base_by_velocity) return match;
  const double good_score = options.second_prior_relative_score * expected_score;
  if (match.score >= good_score) return match;
  ScanMatch by_velocity =
      MatchNear(points_in_base, grid, *prior.submap_from_base_by_velocity, Loosened(options));
  by_velocity.start = MatchStart::kVelocity;
  return by_velocity.score >= good_score ? by_velocity : match;
}

/// What a search found, refined.
ScanMatch Refined(const Pose2& found, const PointCloud& points_in_base, const ProbabilityGrid& grid,
                  const CeresScanMatcherOptions& options) {
  ScanMatch match{found, RefinedPose(points_in_base, grid, found, options), 0.0,
                  MatchStart::kRecovery};
  match.score = MeanProbability(points_in_base, match.submap_from_base, grid);
  return match;
}

/// The best match in the wide window, if it beats `min_score` and `near_score` by enough.
std::optional<ScanMatch> Recover(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                                 const Pose2& submap_from_base_prior, bool prior_is_measured,
                                 double near_score, double min_score,
                                 const LocalSlamOptions& options) {
  const RecoveryOptions& recovery = options.recovery;
  const BranchAndBoundMatcher matcher(grid, kRecoveryDepth);
  const auto search = [&](double linear, double angular,
                          double score_to_beat) -> std::optional<ScanMatch> {
    const SearchOutcome outcome = matcher.Search(points_in_base, submap_from_base_prior, linear,
                                                 angular, std::max(score_to_beat, min_score));
    if (!outcome.winner) return std::nullopt;
    return Refined(outcome.winner->submap_from_scan, points_in_base, grid,
                   options.ceres_scan_matcher);
  };
  const auto search_all = [&](double score_to_beat) {
    return search(recovery.linear_search_window, recovery.angular_search_window, score_to_beat);
  };
  if (prior_is_measured) return search_all(near_score + recovery.min_gain);
  const auto nearer = search(recovery.unmeasured_linear_search_window,
                             recovery.unmeasured_angular_search_window, near_score);
  const double best_score = nearer ? std::max(near_score, nearer->score) : near_score;
  const auto farther = search_all(recovery.unmeasured_min_score_ratio * best_score);
  return farther ? farther : nearer;
}

/// A scan that looks where nothing is known yet scores little wherever it is put; its points among
/// what is known may match as well as expected.
bool MatchesWhatIsKnown(const PointCloud& points_in_base, const ScanMatch& match,
                        const ProbabilityGrid& grid, double min_score,
                        const LocalSlamOptions& options) {
  const KnownScore score = ScoreOfKnown(points_in_base, match.submap_from_base, grid);
  return score.num_points >= options.min_num_matched_points && score.mean_probability >= min_score;
}

}  // namespace

double SizeOf(const Pose2& motion) {
  constexpr double kLever = 2.0;  // [m]
  return std::max(motion.translation.norm(), kLever * std::abs(motion.rotation));
}

ScanMatch MatchScan(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                    const MatchPrior& prior, double expected_score,
                    const LocalSlamOptions& options) {
  const ScanMatch near = MatchAroundPriors(points_in_base, grid, prior, expected_score, options);
  const RecoveryOptions& recovery = options.recovery;
  const double min_score = recovery.min_relative_score * expected_score;
  const double doubtful_score =
      prior.is_measured
          ? min_score
          : std::max(min_score, recovery.unmeasured_min_relative_score * expected_score);
  if (near.score >= doubtful_score) return near;
  // Where a corridor turns, the new one looks as the old one did.
  const bool matches_what_is_known =
      MatchesWhatIsKnown(points_in_base, near, grid, min_score, options);
  if (prior.is_measured && prior.is_far_from_before && matches_what_is_known) return near;
  if (!prior.is_trusted) {
    const auto recovered = Recover(points_in_base, grid, prior.submap_from_base, prior.is_measured,
                                   near.score, min_score, options);
    if (recovered) return *recovered;
  }
  if (matches_what_is_known) return near;
  return {std::nullopt, prior.submap_from_base,
          MeanProbability(points_in_base, prior.submap_from_base, grid), MatchStart::kNone};
}

ScanMatch MatchAsBefore(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                        const Pose2& submap_from_base_before, const MotionPrior& prior,
                        double expected_score, const LocalSlamOptions& options) {
  const CorrelativeMatch likeliest =
      MatchWithPrior(points_in_base, grid, submap_from_base_before, prior);
  ScanMatch match =
      Refined(likeliest.submap_from_scan, points_in_base, grid, options.ceres_scan_matcher);
  if (match.score < options.recovery.min_relative_score * expected_score) {
    match.start = MatchStart::kMotions;
  }
  return match;
}

}  // namespace loopscope
