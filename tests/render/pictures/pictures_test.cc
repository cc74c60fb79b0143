// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/trajectory_error.h"
#include "render/headless/painter.h"
#include "render/views/error_view.h"
#include "tests/render/pictures/expect_picture.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

/// A request written as one expression.
struct Ask : ViewRequest {
  explicit Ask(ViewKind kind) {
    view = kind;
    width = 800;
    height = 500;
  }
  Ask& Step(int value) { return step = value, *this; }
  Ask& Node(int value) { return node = NodeId{value}, *this; }
  Ask& Submap(int value) { return submap = SubmapId{value}, *this; }
  Ask& Size(int w, int h) { return width = w, height = h, *this; }
  Ask& ColorBlind() { return theme = Theme::kColorBlind, *this; }
  Ask& Dark() { return theme = Theme::kDark, *this; }
  Ask& Plain() { return plain = true, *this; }
  Ask& AtLeast(double meters_wide, double meters_high) {
    return width_in_meters = meters_wide, height_in_meters = meters_high, *this;
  }
  Ask& Title(const char* value) { return title = value, *this; }
  Ask& Around(double x, double y, double meters) {
    return center = Eigen::Vector2d(x, y), width_in_meters = meters, *this;
  }
  Ask& From(double degrees, double high) { return azimuth = degrees, elevation = high, *this; }
  Ask& Chart(ChartKind kind) { return chart = kind, *this; }
  Ask& Visits(int value) { return search.num_visits = value, *this; }
  Ask& Height(int value) { return search.height = value, *this; }
  Ask& Angle(int index) { return search.angle_index = index, *this; }
  Ask& Layers(const std::set<LayerKind>& value) { return layers = value, *this; }
};

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

/// The same, mapped with less trust in loops that match elsewhere, too: some are refused.
const Recording& SmallLoopWithRefusedLoops() {
  static const Recording recording = [] {
    Options options = SmallLoopOptions();
    options.pose_graph.constraint_builder.ambiguity.max_relative_score = 0.8;
    return MapLog(SimulateSmallLoop().log, options);
  }();
  return recording;
}

void ExpectView(const std::string& name, const ViewRequest& request, Backend backend,
                const Recording& recording = SmallLoop()) {
  ExpectPicture(Painter(backend).Draw(recording, request), name,
                {LOOPSCOPE_SOURCE_DIR "/tests/baselines", LOOPSCOPE_BINARY_DIR "/pictures"});
}

/// One line per picture: its name, which is that of its baseline, and what is asked for.
#define PICTURE(name, request) \
  TEST(PicturesTest, name) { ExpectView(#name, request, Backend::kOsmesa); }

using V = ViewKind;
using L = LayerKind;

PICTURE(map, Ask(V::kMap))
PICTURE(map_at_first_step, Ask(V::kMap).Step(0))
PICTURE(map_before_loops, Ask(V::kMap).Step(120))
PICTURE(map_tiny, Ask(V::kMap).Size(320, 240))
PICTURE(map_tall, Ask(V::kMap).Size(480, 800))
PICTURE(map_dark, Ask(V::kMap).Dark().Node(122).Submap(1))
PICTURE(map_close_up, Ask(V::kMap).Around(4.1, 0.8, 1.6).Title("A wall, cell by cell"))
PICTURE(map_with_frames, Ask(V::kMap).Layers({L::kGrid, L::kFrames, L::kLabels}))
PICTURE(map_with_selected_node, Ask(V::kMap).Step(120).Node(40))
PICTURE(map_with_selected_loop, Ask(V::kMap).Node(122).Submap(1))
PICTURE(submap, Ask(V::kSubmap))
PICTURE(submap_still_growing, Ask(V::kSubmap).Step(100).Submap(8))
PICTURE(submap_tiny, Ask(V::kSubmap).Size(320, 240))
PICTURE(update, Ask(V::kUpdate).Step(140))
PICTURE(update_by_first_node, Ask(V::kUpdate).Node(0))
PICTURE(update_tiny, Ask(V::kUpdate).Step(140).Size(320, 240))
PICTURE(update_color_blind, Ask(V::kUpdate).Step(140).ColorBlind())
PICTURE(update_dark, Ask(V::kUpdate).Step(140).Dark())
PICTURE(match, Ask(V::kMatch).Step(140))
PICTURE(match_tiny, Ask(V::kMatch).Step(140).Size(320, 240))
PICTURE(match_color_blind, Ask(V::kMatch).Step(140).ColorBlind())
PICTURE(match_dark, Ask(V::kMatch).Step(140).Dark())
PICTURE(search, Ask(V::kSearch))
PICTURE(search_in_vain, Ask(V::kSearch).Node(84).Submap(11))
TEST(PicturesTest, search_refused) {
  ExpectView("search_refused", Ask(V::kSearch).Node(6).Submap(1), Backend::kOsmesa,
             SmallLoopWithRefusedLoops());
}
PICTURE(search_never_done, Ask(V::kSearch).Node(75).Submap(0))
PICTURE(search_after_some_visits, Ask(V::kSearch).Visits(60))
PICTURE(search_at_one_height, Ask(V::kSearch).Visits(100).Height(3).Size(1000, 600))
PICTURE(search_at_one_angle, Ask(V::kSearch).Angle(1).ColorBlind())
PICTURE(search_dark, Ask(V::kSearch).Dark())
PICTURE(search_tiny, Ask(V::kSearch).Size(320, 240))
PICTURE(graph, Ask(V::kGraph))
PICTURE(graph_before_loops, Ask(V::kGraph).Step(120))
PICTURE(graph_covariances, Ask(V::kGraph).Layers({L::kGrid, L::kRefused, L::kCovariances}))
PICTURE(graph_with_selected_loop, Ask(V::kGraph).Node(122).Submap(1))
PICTURE(graph_with_selected_submap, Ask(V::kGraph).Submap(3).ColorBlind())
PICTURE(graph_tiny, Ask(V::kGraph).Size(320, 240))
PICTURE(graph_color_blind, Ask(V::kGraph).ColorBlind())
PICTURE(graph_plain, Ask(V::kGraph).Size(440, 160).AtLeast(3.0, 9.0).Plain())
PICTURE(time, Ask(V::kTime))
PICTURE(time_at_first_step, Ask(V::kTime).Step(0))
PICTURE(time_from_above, Ask(V::kTime).From(0.0, 90.0))
PICTURE(time_tiny, Ask(V::kTime).Size(320, 240))
PICTURE(time_color_blind, Ask(V::kTime).From(70.0, 15.0).ColorBlind())
PICTURE(time_with_selected_loop, Ask(V::kTime).Node(122).Submap(1))
PICTURE(time_with_intra, Ask(V::kTime).Layers({L::kGrid, L::kIntra, L::kNodes, L::kLabels}))
PICTURE(chart_scores, Ask(V::kChart))
PICTURE(chart_scores_at_first_step, Ask(V::kChart).Step(0))
PICTURE(chart_scores_color_blind, Ask(V::kChart).ColorBlind())
PICTURE(chart_scores_dark, Ask(V::kChart).Node(122).Submap(1).Dark())
PICTURE(chart_scores_tiny, Ask(V::kChart).Size(320, 240))
PICTURE(chart_score_histogram, Ask(V::kChart).Chart(ChartKind::kScoreHistogram))
PICTURE(chart_residuals, Ask(V::kChart).Chart(ChartKind::kResiduals))
PICTURE(chart_residual_histogram, Ask(V::kChart).Chart(ChartKind::kResidualHistogram))
PICTURE(chart_costs, Ask(V::kChart).Chart(ChartKind::kCosts))

TEST(PicturesTest, AreTheSameByEgl) {
  ExpectView("update", Ask(V::kUpdate).Step(140), Backend::kEgl);
}

TEST(PicturesTest, AreTheSameEachTime) {
  Painter painter(Backend::kOsmesa);
  const Picture first = painter.Draw(SmallLoop(), Ask(V::kSearch));
  painter.Draw(SmallLoop(), Ask(V::kGraph).Size(500, 400));
  EXPECT_EQ(painter.Draw(SmallLoop(), Ask(V::kSearch)), first);
}

RunErrors ErrorsOfSmallLoop() {
  const Recording& recording = SmallLoop();
  RunErrors errors{"small_loop", "absolute trajectory error", {}, {}, {}, &recording};
  const auto pairs = PairByTime(TrajectoryOf(recording), SimulateSmallLoop().ground_truth);
  const Pose2 map_from_world = AlignToReference(pairs);
  for (const PosePair& pair : pairs) {
    const Pose2& map_from_base = pair.reference_from_base;
    const Pose2 truth = map_from_world * pair.map_from_base;
    errors.way.push_back(map_from_base);
    errors.reference.push_back(truth);
    errors.samples.push_back({map_from_base.translation,
                              (truth.translation - map_from_base.translation).norm(),
                              std::abs(NormalizeAngle(truth.rotation - map_from_base.rotation))});
  }
  return errors;
}

void ExpectErrors(const std::string& name, const RunErrors& errors, const ViewRequest& request) {
  Painter painter(Backend::kOsmesa);
  ExpectPicture(painter.Draw(BuildErrorView(errors, request, OversamplingOf(request))), name,
                {LOOPSCOPE_SOURCE_DIR "/tests/baselines", LOOPSCOPE_BINARY_DIR "/pictures"});
}

TEST(PicturesTest, errors) { ExpectErrors("errors", ErrorsOfSmallLoop(), Ask(V::kMap)); }

TEST(PicturesTest, errors_of_a_trajectory_tiny) {
  RunErrors errors = ErrorsOfSmallLoop();
  errors.recording = nullptr;
  ExpectErrors("errors_of_a_trajectory_tiny", errors, Ask(V::kMap).Size(320, 240).ColorBlind());
}

}  // namespace
}  // namespace loopscope
