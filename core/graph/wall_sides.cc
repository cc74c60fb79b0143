// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/wall_sides.h"

#include <algorithm>

namespace loopscope {
namespace {

/// Along the beam [m]: how far a wall may lie from the return, and where to look for free space.
constexpr double kOnWall[] = {-0.1, -0.05, 0.0, 0.05, 0.1};
constexpr double kBeside[] = {0.15, 0.2, 0.25, 0.3};
constexpr int kMinFreeBehind = 3;  ///< of kBeside

constexpr double kOccupied = 0.5;
constexpr double kFree = 0.45;

/// The grid along the line from the scanner through a return.
class Beam {
 public:
  Beam(const Eigen::Vector2d& scanner, const Eigen::Vector2d& end, const ProbabilityGrid& grid)
      : end_(end), direction_((end - scanner).normalized()), grid_(grid) {}

  bool EndsOnWall() const {
    return std::any_of(std::begin(kOnWall), std::end(kOnWall), [&](double distance) {
      return grid_.probability(CellAt(distance)) >= kOccupied;
    });
  }

  bool ComesFromBehind() const {
    const auto is_free_before = [&](double distance) { return IsFree(-distance); };
    const auto is_free_behind = [&](double distance) { return IsFree(distance); };
    return std::none_of(std::begin(kBeside), std::end(kBeside), is_free_before) &&
           std::count_if(std::begin(kBeside), std::end(kBeside), is_free_behind) >= kMinFreeBehind;
  }

 private:
  /// `distance` [m] behind the return.
  CellIndex CellAt(double distance) const {
    return CellOf(end_ + distance * direction_, grid_.resolution());
  }
  bool IsFree(double distance) const {
    const CellIndex cell = CellAt(distance);
    return grid_.known(cell) && grid_.probability(cell) < kFree;
  }

  Eigen::Vector2d end_;
  Eigen::Vector2d direction_;
  const ProbabilityGrid& grid_;
};

}  // namespace

ReturnsOnWalls FindReturnsOnWalls(const RangeData& scan, const Pose2& submap_from_scan,
                                  const ProbabilityGrid& grid) {
  const Eigen::Vector2d origin = submap_from_scan * scan.origin;
  ReturnsOnWalls returns;
  for (const Eigen::Vector2d& point : Transform(submap_from_scan, scan.returns)) {
    const Beam beam(origin, point, grid);
    if (!beam.EndsOnWall()) continue;
    ++returns.count;
    if (beam.ComesFromBehind()) returns.from_behind.push_back(point);
  }
  return returns;
}

}  // namespace loopscope
