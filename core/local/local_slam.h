// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/local/active_submaps.h"
#include "core/local/local_slam_options.h"
#include "core/local/match_start.h"
#include "core/local/pose_extrapolator.h"
#include "core/local/scan_matching.h"
#include "core/local/used_odometry.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

/// What local SLAM made of a scan.
struct LocalSlamResult {
  std::optional<Pose2> odom_from_base;               ///< UsedOdometry
  Pose2 local_from_base_prior;                       ///< extrapolated; Rounded, like those below
  std::optional<Pose2> local_from_base_correlative;  ///< after the correlative matcher, if it ran
  Pose2 local_from_base;                             ///< after (CS), or extrapolated
  MatchStart match_start = MatchStart::kNone;
  bool wide_walls = false;           ///< whether it was matched WithWideWalls
  MotionKnowledge motion_knowledge;  ///< of the motion since the scan before
  bool has_returns = false;
  RangeData range_data;                               ///< in the frame of the robot
  std::optional<ActiveSubmaps::Insertion> insertion;  ///< unless the motion filter dropped the scan
};

/// Builds submaps from scans: each scan is matched against the submap that is being built and then
/// inserted. Drifts over time; the pose graph corrects that.
class LocalSlam {
 public:
  /// Keeps a reference to `log`.
  LocalSlam(const ScanLog& log, const LocalSlamOptions& options);

  /// Adds scan `scan` of the log; scans are added in their order. Throws std::length_error if no
  /// map could hold where the robot is.
  LocalSlamResult AddScan(int scan);

 private:
  struct ScanToMatch {
    int index;
    const PointCloud& points;  ///< in the frame of the robot
    bool is_far_from_before;   ///< see IsFarFromBefore
  };
  /// What a scan is matched with.
  struct MatchedSubmap {
    const Pose2& local_from_submap;
    const ProbabilityGrid& grid;  ///< of the submap, or WithWideWalls
  };

  void Match(int scan, LocalSlamResult* result);
  /// Whether odometry measured the motion since the scan before, and one as it often does.
  bool IsUsual(const std::optional<Pose2>& odom_from_base) const;
  /// Whether the match hardly corrects where odometry has the scan, by
  /// max_correction_between_nodes.
  bool AgreesWithOdometry(const LocalSlamResult& result) const;
  void LearnExpectedScore(double score);
  /// Where the scan is: where it matched, or by those ahead if it matches nowhere.
  void SetPose(int scan, const ScanMatch& match, const MatchedSubmap& submap,
               LocalSlamResult* result) const;
  /// Whether the robot went so far since the scan before that velocity says little.
  bool IsFarFromBefore(int scan) const;
  MatchPrior PriorOf(const ScanToMatch& scan, const LocalSlamResult& result,
                     const MatchedSubmap& submap) const;
  Pose2 SubmapFromBaseByVelocity(int scan, const MatchedSubmap& submap) const;
  /// What is asked of a match without odometry, where that is doubted.
  struct Doubt {
    double min_score_ratio = 0.0;  ///< how many times as much as with odometry it must score,
    int num_scans_ahead = 0;       ///< together with so many scans ahead
  };
  /// Nothing if there is no reason to doubt odometry, which led to `match`.
  std::optional<Doubt> DoubtIn(const Pose2& odom_from_base, const ScanMatch& match) const;
  /// Where the scan matches whatever odometry says.
  ScanMatch MatchWithoutOdometry(const ScanToMatch& scan, const MatchedSubmap& submap) const;
  /// Where odometry has the scan; or if that is doubtful, where the scan matches without odometry,
  /// if the robot ever made a motion like that. If it matches at neither, where the motions before
  /// have it.
  ScanMatch MatchInDoubt(const ScanToMatch& scan, const LocalSlamResult& result,
                         const MatchedSubmap& submap) const;
  /// Where a scan is expected.
  struct Prediction {
    Pose2 local_from_base;
    std::optional<Pose2> odom_from_base;  ///< UsedOdometry
    bool is_measured = false;             ///< by odometry
  };
  Prediction Predict(int scan, const PoseExtrapolator& extrapolator) const;
  /// Matches a scan that comes later; nothing if it has too few points.
  std::optional<ScanMatch> MatchScanAhead(int scan, const Prediction& prediction,
                                          const MatchedSubmap& submap, double expected_score) const;
  /// The sum of the scores of the `num_scans` scans that follow `scan`, each around where odometry
  /// leads to if `scan` was at `submap_from_base`.
  double ScoreOfScansAhead(int scan, const Pose2& submap_from_base, const MatchedSubmap& submap,
                           int num_scans) const;
  /// Where scan `scan` was, which matches nowhere in `submap`: between the scan before it and the
  /// first of those ahead that does match there.
  std::optional<Pose2> PlaceByScansAhead(int scan, const MatchedSubmap& submap) const;

  const ScanLog& log_;
  LocalSlamOptions options_;
  OdometryOfScans odometry_;  ///< UsedOdometry
  PoseExtrapolator extrapolator_;
  MotionFilter motion_filter_;
  ActiveSubmaps active_submaps_;
  /// Since the last scan that matched it measured all motions, and did nothing unusual.
  bool odometry_is_trusted_ = false;
  int num_matched_ = 0;          ///< of the scans so far
  double expected_score_ = 0.0;  ///< of a match: running average of those before
};

}  // namespace loopscope
