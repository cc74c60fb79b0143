// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopscope {
namespace {

constexpr double kBucketSize = 0.5;  // [m]

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Whether the line of `segment` has all of the square around `center` on one side.
bool PassesBy(const Segment& segment, const Eigen::Vector2d& center) {
  constexpr double kHalf = kBucketSize / 2.0 * (1.0 + 1e-9);
  const Eigen::Vector2d along = segment.to - segment.from;
  const double reach = kHalf * (std::abs(along.x()) + std::abs(along.y()));
  return std::abs(Cross(along, center - segment.from)) > reach;
}

// The walk of a ray over the lines between buckets of one axis.
struct AxisWalk {
  AxisWalk(double origin, double direction)
      : bucket(static_cast<int>(std::floor(origin))),
        step(direction < 0.0 ? -1 : 1),
        delta(direction == 0.0 ? kInfinity : std::abs(1.0 / direction)),
        next(direction == 0.0 ? kInfinity
                              : (bucket + (direction < 0.0 ? 0 : 1) - origin) / direction) {}

  void Advance() {
    bucket += step;
    next += delta;
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  int bucket;
  int step;
  double delta;  // of the ray's length between two lines [buckets]
  double next;   // length of the ray at the next line [buckets]
};

}  // namespace

std::optional<double> Intersect(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                const Segment& segment) {
  // Lets no ray slip through where two segments meet.
  constexpr double kOverlap = 1e-9;
  const Eigen::Vector2d along = segment.to - segment.from;
  const double denominator = Cross(direction, along);
  if (denominator == 0.0) return std::nullopt;
  const Eigen::Vector2d origin_to_from = segment.from - origin;
  const double distance = Cross(origin_to_from, along) / denominator;
  const double share = Cross(origin_to_from, direction) / denominator;
  if (distance < 0.0 || share < -kOverlap || share > 1.0 + kOverlap) return std::nullopt;
  return distance;
}

RayCaster::RayCaster(const FloorPlan& plan) : segments_(plan.segments()) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Array2d low(kInfinity, kInfinity);
  Eigen::Array2d high(-kInfinity, -kInfinity);
  for (const Segment& segment : segments_) {
    low = low.min(segment.from.array()).min(segment.to.array());
    high = high.max(segment.from.array()).max(segment.to.array());
  }
  if (!segments_.empty()) {
    low_ = low - kBucketSize / 2.0;
    width_ = static_cast<int>((high.x() - low_.x()) / kBucketSize) + 2;
    height_ = static_cast<int>((high.y() - low_.y()) / kBucketSize) + 2;
  }
  buckets_.resize(static_cast<size_t>(width_) * height_);
  for (int i = 0; i < static_cast<int>(segments_.size()); ++i) SortIntoBuckets(i);
}

void RayCaster::SortIntoBuckets(int index) {
  const Segment& segment = segments_[index];
  const Eigen::Array2d from = (segment.from - low_) / kBucketSize;
  const Eigen::Array2d to = (segment.to - low_) / kBucketSize;
  // A hair more, for segments that lie on a line between buckets.
  const Eigen::Array2i low = (from.min(to) - 1e-6).floor().cast<int>().max(0);
  const Eigen::Array2i high = (from.max(to) + 1e-6).floor().cast<int>();
  for (int y = low.y(); y <= high.y(); ++y) {
    for (int x = low.x(); x <= high.x(); ++x) {
      const Eigen::Vector2d center = low_ + kBucketSize * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (!PassesBy(segment, center)) buckets_[y * width_ + x].push_back(index);
    }
  }
}

std::optional<double> RayCaster::Distance(const Eigen::Vector2d& origin, double angle,
                                          double max_range) const {
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d start = (origin - low_) / kBucketSize;
  AxisWalk x(start.x(), direction.x());
  AxisWalk y(start.y(), direction.y());
  double nearest = max_range;
  bool found = false;
  double entered = 0.0;  // length of the ray where it entered the bucket [m]
  while (entered <= nearest && x.bucket >= 0 && x.bucket < width_ && y.bucket >= 0 &&
         y.bucket < height_) {
    for (const int i : Bucket(x.bucket, y.bucket)) {
      const std::optional<double> distance = Intersect(origin, direction, segments_[i]);
      if (!distance || *distance > nearest) continue;
      nearest = *distance;
      found = true;
    }
    AxisWalk& nearer_line = x.next < y.next ? x : y;
    entered = nearer_line.next * kBucketSize;
    nearer_line.Advance();
  }
  return found ? std::optional<double>(nearest) : std::nullopt;
}

}  // namespace loopscope
