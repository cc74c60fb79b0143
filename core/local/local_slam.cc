// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/local_slam.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "core/local/changed_ranges.h"
#include "core/local/scan_preparation.h"
#include "core/local/shared_jump.h"
#include "core/matching/match_score.h"
#include "core/matching/wide_walls.h"

namespace loopscope {
namespace {

void RequireInMap(const Pose2& local_from_base) {
  if (IsInMap(local_from_base)) return;
  throw std::length_error(
      fmt::format("the robot is {:.3g} m from where it began, too far for a map",
                  local_from_base.translation.norm()));
}

/// The expected score forgets within some twenty scans, of which the first count alike.
constexpr double kExpectedScoreGain = 0.05;

/// The velocity of a robot that sets out tells little.
constexpr int kNumScansUntilVelocityIsKnown = 20;

/// Odometry is right again behind a jump, so that the scans ahead of it match where the one at it
/// was, and not where odometry has that.
constexpr int kNumScansThatTellAJump = 3;

/// Of the expected score. Behind a jump a scan matches less where odometry has it, while the scans
/// ahead may well match elsewhere: round a corner a new corridor looks as the old one did.
constexpr double kShareThatIsNotDoubted = 0.8;

}  // namespace

LocalSlam::LocalSlam(const ScanLog& log, const LocalSlamOptions& options)
    : log_(log),
      options_(options),
      odometry_(UsedOdometry(log, options)),
      extrapolator_(OdometryCalibration(options.odometry_calibration_memory),
                    SteadyPace(options.steady_pace_memory), options.velocity_gain),
      motion_filter_(options.motion_filter),
      active_submaps_(options.submaps) {}

LocalSlamResult LocalSlam::AddScan(int scan) {
  const double time = log_.scans[scan].time;
  LocalSlamResult result;
  const Prediction prediction = Predict(scan, extrapolator_);
  result.odom_from_base = prediction.odom_from_base;
  result.range_data = PrepareRangeData(log_, scan, options_);
  result.has_returns = !result.range_data.returns.empty();
  result.local_from_base_prior = Rounded(prediction.local_from_base);
  result.local_from_base = result.local_from_base_prior;
  odometry_is_trusted_ = odometry_is_trusted_ && IsUsual(result.odom_from_base);
  if (result.has_returns) Match(scan, &result);
  RequireInMap(result.local_from_base);
  const bool is_inserted =
      result.has_returns && !motion_filter_.IsSimilar(time, result.local_from_base);
  result.motion_knowledge.odometry_goes_on = !is_inserted && AgreesWithOdometry(result);
  extrapolator_.AddPose(time, result.local_from_base, result.odom_from_base,
                        result.motion_knowledge);
  if (is_inserted) {
    result.insertion = active_submaps_.Insert(result.local_from_base, result.range_data);
  }
  return result;
}

bool LocalSlam::IsUsual(const std::optional<Pose2>& odom_from_base) const {
  return num_matched_ >= kNumScansUntilVelocityIsKnown &&
         extrapolator_.MotionIsMeasured(odom_from_base) &&
         !extrapolator_.IsUnusual(*odom_from_base);
}

bool LocalSlam::AgreesWithOdometry(const LocalSlamResult& result) const {
  const Pose2 correction = result.local_from_base_prior.Inverse() * result.local_from_base;
  return result.match_start == MatchStart::kPrior &&
         extrapolator_.MotionIsMeasured(result.odom_from_base) &&
         !extrapolator_.StandsStill(*result.odom_from_base) &&
         SizeOf(correction) < options_.max_correction_between_nodes;
}

void LocalSlam::Match(int scan, LocalSlamResult* result) {
  const ActiveSubmap* active = active_submaps_.MatchingSubmap();
  if (active == nullptr) return;
  const std::optional<PointCloud> points = PointsToMatch(result->range_data, options_);
  if (!points) return;
  const ScanToMatch scan_to_match{scan, *points, IsFarFromBefore(scan)};
  std::optional<ProbabilityGrid> wide_walls;
  const bool is_measured = extrapolator_.MotionIsMeasured(result->odom_from_base);
  const bool may_be_held_back = !is_measured || scan_to_match.is_far_from_before;
  if (options_.share_beside_walls > 0.0 && may_be_held_back) {
    wide_walls = WithWideWalls(active->grid, options_.share_beside_walls);
    result->wide_walls = true;
  }
  const MatchedSubmap submap{active->local_from_submap, wide_walls ? *wide_walls : active->grid};
  const ScanMatch match = MatchInDoubt(scan_to_match, *result, submap);
  LearnExpectedScore(match.score);
  SetPose(scan, match, submap, result);
  odometry_is_trusted_ = odometry_is_trusted_ || result->match_start != MatchStart::kNone;
  const bool is_as_measured = is_measured && match.start == MatchStart::kPrior;
  const bool is_held =
      !MatchedNowhere(match.start) && HoldsAhead(*points, match.submap_from_base, active->grid);
  result->motion_knowledge = {is_as_measured || is_held, is_as_measured && is_held};
}

void LocalSlam::LearnExpectedScore(double score) {
  ++num_matched_;
  expected_score_ += std::max(kExpectedScoreGain, 1.0 / num_matched_) * (score - expected_score_);
}

void LocalSlam::SetPose(int scan, const ScanMatch& match, const MatchedSubmap& submap,
                        LocalSlamResult* result) const {
  const Pose2& local_from_submap = submap.local_from_submap;
  if (match.submap_from_base_correlative) {
    result->local_from_base_correlative =
        Rounded(local_from_submap * *match.submap_from_base_correlative);
  }
  result->match_start = match.start;
  if (match.start != MatchStart::kNone || !extrapolator_.MotionIsMeasured(result->odom_from_base)) {
    result->local_from_base = Rounded(local_from_submap * match.submap_from_base);
  } else if (const auto local_from_base = PlaceByScansAhead(scan, submap)) {
    result->local_from_base = Rounded(*local_from_base);
    result->match_start = MatchStart::kAhead;
  }
}

bool LocalSlam::IsFarFromBefore(int scan) const {
  const PastMotions& motions = extrapolator_.past_motions();
  return motions.SayMoreThanVelocity() || (motions.AreFew() && ShowsAnotherPlace(log_, scan));
}

MatchPrior LocalSlam::PriorOf(const ScanToMatch& scan, const LocalSlamResult& result,
                              const MatchedSubmap& submap) const {
  MatchPrior prior{submap.local_from_submap.Inverse() * result.local_from_base_prior, true};
  prior.is_far_from_before = scan.is_far_from_before;
  prior.is_trusted = odometry_is_trusted_;
  prior.motion_size = SizeOf(extrapolator_.LastPose().Inverse() * result.local_from_base_prior);
  if (num_matched_ >= kNumScansUntilVelocityIsKnown) {
    prior.submap_from_base_by_velocity = SubmapFromBaseByVelocity(scan.index, submap);
  }
  return prior;
}

Pose2 LocalSlam::SubmapFromBaseByVelocity(int scan, const MatchedSubmap& submap) const {
  return submap.local_from_submap.Inverse() *
         extrapolator_.PredictByVelocity(log_.scans[scan].time);
}

std::optional<LocalSlam::Doubt> LocalSlam::DoubtIn(const Pose2& odom_from_base,
                                                   const ScanMatch& match) const {
  if (num_matched_ < kNumScansUntilVelocityIsKnown) return std::nullopt;
  Doubt doubt;
  if (extrapolator_.StandsStill(odom_from_base)) {
    doubt = {options_.standstill_min_score_ratio, 0};
  } else if (match.score < kShareThatIsNotDoubted * expected_score_ &&
             (extrapolator_.IsUnusual(odom_from_base) || match.start == MatchStart::kNone)) {
    doubt = {options_.unusual_motion_min_score_ratio, kNumScansThatTellAJump};
  }
  return doubt.min_score_ratio > 0.0 ? std::optional<Doubt>(doubt) : std::nullopt;
}

ScanMatch LocalSlam::MatchWithoutOdometry(const ScanToMatch& scan,
                                          const MatchedSubmap& submap) const {
  const Pose2 submap_from_base_before =
      submap.local_from_submap.Inverse() * extrapolator_.LastPose();
  if (options_.past_motions_weight > 0.0 && scan.is_far_from_before) {
    return MatchAsBefore(scan.points, submap.grid, submap_from_base_before,
                         extrapolator_.past_motions().Prior(options_.past_motions_weight),
                         expected_score_, options_);
  }
  ScanMatch match =
      MatchScan(scan.points, submap.grid, {SubmapFromBaseByVelocity(scan.index, submap)},
                expected_score_, options_);
  if (match.start == MatchStart::kNone) match.submap_from_base = submap_from_base_before;
  return match;
}

ScanMatch LocalSlam::MatchInDoubt(const ScanToMatch& scan, const LocalSlamResult& result,
                                  const MatchedSubmap& submap) const {
  if (!extrapolator_.MotionIsMeasured(result.odom_from_base)) {
    return MatchWithoutOdometry(scan, submap);
  }
  const ScanMatch match =
      MatchScan(scan.points, submap.grid, PriorOf(scan, result, submap), expected_score_, options_);
  const std::optional<Doubt> doubt = DoubtIn(*result.odom_from_base, match);
  if (!doubt) return match;
  ScanMatch without_odometry = MatchWithoutOdometry(scan, submap);
  if (without_odometry.start == MatchStart::kNone) return match;
  if (without_odometry.start == MatchStart::kMotions && match.start != MatchStart::kNone) {
    return match;
  }
  const Pose2 motion_without_odometry = extrapolator_.LastPose().Inverse() *
                                        submap.local_from_submap *
                                        without_odometry.submap_from_base;
  if (!extrapolator_.past_motions().HaveOneLike(motion_without_odometry)) return match;
  const auto score = [&](const ScanMatch& at) {
    return at.score +
           ScoreOfScansAhead(scan.index, at.submap_from_base, submap, doubt->num_scans_ahead);
  };
  if (score(without_odometry) < doubt->min_score_ratio * score(match)) return match;
  if (without_odometry.start == MatchStart::kPrior) without_odometry.start = MatchStart::kVelocity;
  return without_odometry;
}

LocalSlam::Prediction LocalSlam::Predict(int scan, const PoseExtrapolator& extrapolator) const {
  const std::optional<Pose2>& odom_from_base = odometry_[scan];
  return {extrapolator.Predict(log_.scans[scan].time, odom_from_base), odom_from_base,
          extrapolator.MotionIsMeasured(odom_from_base)};
}

std::optional<ScanMatch> LocalSlam::MatchScanAhead(int scan, const Prediction& prediction,
                                                   const MatchedSubmap& submap,
                                                   double expected_score) const {
  const auto points = PointsToMatch(PrepareRangeData(log_, scan, options_), options_);
  if (!points) return std::nullopt;
  MatchPrior prior{submap.local_from_submap.Inverse() * prediction.local_from_base,
                   prediction.is_measured};
  prior.is_trusted = odometry_is_trusted_;
  return MatchScan(*points, submap.grid, prior, expected_score, options_);
}

double LocalSlam::ScoreOfScansAhead(int scan, const Pose2& submap_from_base,
                                    const MatchedSubmap& submap, int num_scans) const {
  PoseExtrapolator extrapolator = extrapolator_;
  const auto add_pose = [&](int at, const Pose2& local_from_base,
                            const std::optional<Pose2>& odom_from_base) {
    extrapolator.AddPose(log_.scans[at].time, local_from_base, odom_from_base, MotionKnowledge());
  };
  add_pose(scan, submap.local_from_submap * submap_from_base, odometry_[scan]);
  const int end = std::min(scan + 1 + num_scans, static_cast<int>(log_.scans.size()));
  double sum = 0.0;
  for (int ahead = scan + 1; ahead < end; ++ahead) {
    const Prediction prediction = Predict(ahead, extrapolator);
    Pose2 local_from_base = prediction.local_from_base;
    constexpr double kAnyScore = 0.0;
    if (const auto match = MatchScanAhead(ahead, prediction, submap, kAnyScore)) {
      sum += match->score;
      local_from_base = submap.local_from_submap * match->submap_from_base;
    }
    add_pose(ahead, local_from_base, prediction.odom_from_base);
  }
  return sum;
}

std::optional<Pose2> LocalSlam::PlaceByScansAhead(int scan, const MatchedSubmap& submap) const {
  const int end = std::min(scan + 1 + options_.recovery.max_num_scans_ahead,
                           static_cast<int>(log_.scans.size()));
  PoseExtrapolator extrapolator = extrapolator_;
  std::vector<Pose2> local_from_predicted;
  for (int ahead = scan; ahead < end; ++ahead) {
    const Prediction prediction = Predict(ahead, extrapolator);
    extrapolator.AddPose(log_.scans[ahead].time, prediction.local_from_base,
                         prediction.odom_from_base, MotionKnowledge());
    local_from_predicted.push_back(prediction.local_from_base);
    if (ahead == scan) continue;
    const auto match = MatchScanAhead(ahead, prediction, submap, expected_score_);
    if (!match || match->start == MatchStart::kNone) continue;
    return FirstOfSharedJump(extrapolator_.LastPose(), local_from_predicted,
                             submap.local_from_submap * match->submap_from_base);
  }
  return std::nullopt;
}

}  // namespace loopscope
