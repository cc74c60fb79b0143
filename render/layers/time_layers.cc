// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/time_layers.h"

#include <algorithm>
#include <cassert>

#include "render/layers/shapes.h"
#include "render/scale_bar.h"
#include "render/scene.h"

namespace loopscope {

TimeScale TimeScaleOf(const Recording& recording, double share) {
  Extent extent;
  for (const Node& node : recording.nodes()) extent.extend(node.local_from_base.translation);
  const auto& scans = recording.log().scans;
  const double duration = scans[recording.num_steps() - 1].time - scans.front().time;
  constexpr double kMinSize = 1.0;      // [m] of a robot that stands still
  constexpr double kMinDuration = 0.1;  // [s] of a single scan
  const double size = extent.isEmpty() ? 0.0 : extent.sizes().maxCoeff();
  return {scans.front().time, share * std::max(size, kMinSize) / std::max(duration, kMinDuration)};
}

std::vector<double> HeightsOfNodes(const Recording& recording, const TimeScale& scale, int count) {
  std::vector<double> heights;
  for (NodeId id{0}; id.index < count; ++id.index) {
    heights.push_back(scale.HeightAt(recording.log().scans[recording.node(id).step].time));
  }
  return heights;
}

std::vector<double> HeightsOfSubmaps(const Recording& recording, const TimeScale& scale,
                                     int count) {
  std::vector<double> heights;
  for (SubmapId id{0}; id.index < count; ++id.index) {
    const Node& first = recording.node(recording.submap(id).first_node);
    heights.push_back(scale.HeightAt(recording.log().scans[first.step].time));
  }
  return heights;
}

vtkSmartPointer<vtkActor> RisingTrajectoryLayer(const std::vector<Pose2>& poses,
                                                const std::vector<double>& heights,
                                                const Color& color, double line_width) {
  assert(poses.size() == heights.size());
  Shapes shapes;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    shapes.AddSlope(poses[i - 1].translation, heights[i - 1], poses[i].translation, heights[i],
                    color);
  }
  return MakeSolidActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> RisingNodesLayer(const std::vector<Pose2>& poses,
                                           const std::vector<double>& heights, const Color& color,
                                           double size) {
  assert(poses.size() == heights.size());
  Shapes shapes;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    shapes.SetHeight(heights[i]);
    shapes.AddPoint(poses[i].translation, color);
  }
  return MakeSolidActor(shapes.Build(), {1.0, size, true});
}

vtkSmartPointer<vtkActor> RisingFramesLayer(const std::vector<Pose2>& map_from_frame,
                                            const std::vector<double>& heights, double length,
                                            double line_width, const Palette& palette) {
  assert(map_from_frame.size() == heights.size());
  Shapes shapes;
  for (std::size_t i = 0; i < map_from_frame.size(); ++i) {
    const Pose2& frame = map_from_frame[i];
    shapes.SetHeight(heights[i]);
    shapes.AddLine(frame.translation, frame * Eigen::Vector2d(length, 0.0), palette.axis_x);
    shapes.AddLine(frame.translation, frame * Eigen::Vector2d(0.0, length), palette.axis_y);
  }
  return MakeSolidActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> RisingConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                 const std::vector<double>& submap_heights,
                                                 const std::vector<double>& node_heights,
                                                 const std::optional<Color>& color, double opacity,
                                                 double line_width) {
  Shapes shapes;
  for (const PlacedConstraint& c : constraints) {
    const int submap = c.constraint.submap.index;
    shapes.AddSlope(c.submap, submap_heights[submap], c.expected_node,
                    node_heights[c.constraint.node.index],
                    WithOpacity(color.value_or(HueOf(submap)), opacity));
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

std::vector<double> TicksUpTo(double duration) {
  constexpr double kNumTicks = 4.0;  // at least, beside that at 0
  const double step = RoundLength(duration / kNumTicks);
  std::vector<double> ticks{0.0};
  for (int i = 1; step > 0.0 && i * step <= duration; ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace loopscope
