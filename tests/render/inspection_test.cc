// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/inspection.h"

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/cell_history.h"
#include "core/slam/derive.h"
#include "render/charts/recording_charts.h"
#include "render/layers/constraints.h"
#include "render/layers/search_tree.h"
#include "render/layout.h"
#include "render/views/chart_plot.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

using Vector = Eigen::Vector2d;

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

ViewRequest RequestFor(ViewKind view) {
  ViewRequest request;
  request.view = view;
  return request;
}

Inspector InspectorFor(const ViewRequest& request) {
  DerivedCache cache(SmallLoop());
  return Inspector(&cache, request, BuildScene(&cache, request));
}

/// The fact called `name`, or "" if there is none.
std::string ValueOf(const Finding& finding, const std::string& name) {
  for (const Fact& fact : finding.facts) {
    if (fact.name == name) return fact.value;
  }
  return "";
}

MapState LastState() { return StateAfterStep(SmallLoop(), SmallLoop().num_steps() - 1); }

TEST(InspectorTest, FindsTheNearestNodeOfAGraph) {
  const Vector place = LastState().global_from_node[40].translation;
  const auto finding =
      InspectorFor(RequestFor(ViewKind::kGraph)).WhatIsAt(0, place + Vector(0.01, 0.0), 0.1);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->node, NodeId{40});
  EXPECT_FALSE(finding->submap);
  EXPECT_EQ(ValueOf(*finding, "node"), "(0, 40)");
  EXPECT_EQ(ValueOf(*finding, "x"), fmt::format("{:.2f} m", place.x()));
}

TEST(InspectorTest, FindsNothingInTheGraphOverTime) {
  EXPECT_FALSE(InspectorFor(RequestFor(ViewKind::kTime)).WhatIsAt(0, {0.5, 0.5}, 100.0));
}

/// Where values stand in the panel of the chart that `request` asks for.
Vector PlaceInChart(const ViewRequest& request, double x, double y) {
  const Panel panel = BuildScene(SmallLoop(), request).panels.front();
  const SheetSize size = MakeSheetSize(request.width, request.height, 1, request.text_height);
  const ChartData data = ChartOf(SmallLoop(), request.chart, SmallLoop().num_steps() - 1);
  return PlaceChart(data, panel.frame.width / panel.frame.height, TextStyleOf(size, {}),
                    panel.camera.meters_per_pixel)
      .plot.At(x, y);
}

TEST(InspectorTest, FindsTheLoopOfAPointInAChart) {
  const ViewRequest request = RequestFor(ViewKind::kChart);
  const auto& candidates = SmallLoop().candidates();
  const auto loop = std::find_if(candidates.begin(), candidates.end(), [](const auto& candidate) {
    return candidate.verdict == Verdict::kAccepted;
  });
  const Vector place = PlaceInChart(request, loop->considered_step, loop->score - loop->min_score);
  const auto finding = InspectorFor(request).WhatIsAt(0, place, 0.0);
  ASSERT_TRUE(finding.has_value());
  EXPECT_EQ(ValueOf(*finding, "min_score"), fmt::format("{:.4g}", loop->min_score));
  EXPECT_EQ(finding->loop, static_cast<int>(loop - candidates.begin()));
  EXPECT_EQ(finding->step, loop->considered_step);
  EXPECT_FALSE(InspectorFor(request).WhatIsAt(0, {-1.0, -1.0}, 0.0).has_value());
}

TEST(InspectorTest, FindsTheRangeOfABarOfAHistogram) {
  ViewRequest request = RequestFor(ViewKind::kChart);
  request.chart = ChartKind::kResidualHistogram;
  const ChartData data = ChartOf(SmallLoop(), request.chart, SmallLoop().num_steps() - 1);
  const ChartBar& bar = data.series.front().bars.front();
  const double middle = std::sqrt(bar.begin * bar.end);  // the axis is logarithmic
  const Vector place = PlaceInChart(request, middle, 0.5 * (bar.low + bar.high));
  const auto finding = InspectorFor(request).WhatIsAt(0, place, 0.0);
  ASSERT_TRUE(finding.has_value() && finding->range.has_value());
  EXPECT_EQ(finding->range->quantity, "residual");
  EXPECT_EQ(finding->range->begin, 0.0) << "the first bar holds all that is less";
  EXPECT_EQ(finding->range->end, bar.end);
}

TEST(InspectorTest, FindsNothingWhereNothingIsNear) {
  const Inspector inspector = InspectorFor(RequestFor(ViewKind::kGraph));
  EXPECT_FALSE(inspector.WhatIsAt(0, {100.0, 100.0}, 0.5));
}

TEST(InspectorTest, FindsAConstraintWhereNoNodeIsAndInterBeforeIntra) {
  const MapState state = LastState();
  const std::vector<Constraint> constraints = ConstraintsOf(SmallLoop(), state);
  const Inspector inspector = InspectorFor(RequestFor(ViewKind::kGraph));
  int num_inter = 0;
  int num_intra = 0;
  for (const Constraint& constraint : constraints) {
    const auto placed = PlaceConstraints({constraint}, constraint.tag, state).front();
    const auto finding =
        inspector.WhatIsAt(0, 0.4 * placed.submap + 0.6 * placed.expected_node, 1e-3);
    ASSERT_TRUE(finding);
    if (ValueOf(*finding, "constraint").empty()) continue;  // a node stands there
    ASSERT_TRUE(finding->node && finding->submap);
    const bool found_inter = ValueOf(*finding, "constraint") == "INTER";
    num_inter += found_inter;
    num_intra += !found_inter;
    EXPECT_TRUE(found_inter || constraint.tag == Constraint::Tag::kIntraSubmap);
    EXPECT_EQ(ValueOf(*finding, "score").empty(), !found_inter);
    EXPECT_FALSE(ValueOf(*finding, "residual").empty());
  }
  EXPECT_GT(num_inter, 10);
  EXPECT_GT(num_intra, 10);
}

TEST(InspectorTest, FindsOnlyConstraintsThatAreDrawn) {
  const MapState state = LastState();
  const auto inter =
      PlaceConstraints(ConstraintsOf(SmallLoop(), state), Constraint::Tag::kInterSubmap, state);
  const Inspector map = InspectorFor(RequestFor(ViewKind::kMap));
  ViewRequest request = RequestFor(ViewKind::kGraph);
  request.layers = std::set<LayerKind>{LayerKind::kGrid};
  const Inspector bare = InspectorFor(request);
  for (const PlacedConstraint& placed : inter) {
    for (const Inspector* const inspector : {&map, &bare}) {
      const auto finding =
          inspector->WhatIsAt(0, 0.4 * placed.submap + 0.6 * placed.expected_node, 1e-3);
      EXPECT_TRUE(!finding || ValueOf(*finding, "constraint").empty());
    }
  }
}

TEST(InspectorTest, FindsTheOriginOfASubmapBehindNodesAndConstraints) {
  const MapState state = LastState();
  const Inspector inspector = InspectorFor(RequestFor(ViewKind::kMap));
  int num_found = 0;
  for (int i = 0; i < state.num_submaps; ++i) {
    const auto finding = inspector.WhatIsAt(0, state.global_from_submap[i].translation, 1e-6);
    if (!finding || finding->node) continue;  // the node that began it stands there
    EXPECT_EQ(finding->submap, SubmapId{i});
    EXPECT_EQ(ValueOf(*finding, "submap"), ToString(SubmapId{i}));
    ++num_found;
  }
  EXPECT_GT(num_found, 0);
}

TEST(InspectorTest, TellsOfACellOfASubmapHowOftenItWasHitAndMissed) {
  ViewRequest request = RequestFor(ViewKind::kSubmap);
  request.submap = SubmapId{3};
  const CellHistory history(SmallLoop(), SubmapId{3});
  const ProbabilityGrid grid = GridOfSubmap(SmallLoop(), SubmapId{3});
  const NodeId first = SmallLoop().submap(SubmapId{3}).first_node;
  const CellIndex cell = CellsOfNode(SmallLoop(), SubmapId{3}, first).hits.front();
  const auto writes = history.WritesOf(cell);
  const auto num_hits =
      std::count_if(writes.begin(), writes.end(), [](const CellWrite& w) { return w.is_hit; });
  const auto finding = InspectorFor(request).WhatIsAt(0, CenterOf(cell, 0.05), 0.01);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->submap, SubmapId{3});
  EXPECT_EQ(ValueOf(*finding, "probability"), fmt::format("{:.3f}", grid.probability(cell)));
  EXPECT_EQ(ValueOf(*finding, "hits"), std::to_string(num_hits));
  EXPECT_EQ(ValueOf(*finding, "misses"), std::to_string(writes.size() - num_hits));
  EXPECT_THAT(ValueOf(*finding, "hit by nodes"), testing::StartsWith(std::to_string(first.index)));
}

TEST(InspectorTest, FindsANodeOfASubmap) {
  ViewRequest request = RequestFor(ViewKind::kSubmap);
  request.submap = SubmapId{3};
  const NodeId third{SmallLoop().submap(SubmapId{3}).first_node.index + 2};
  const Vector place = SubmapFromNode(SmallLoop(), SubmapId{3}, third).translation;
  EXPECT_EQ(InspectorFor(request).WhatIsAt(0, place, 0.01)->node, third);
  EXPECT_FALSE(InspectorFor(request).WhatIsAt(0, place + Vector(0.0, 0.5), 0.01)->node);
}

TEST(InspectorTest, TellsWhatAnUpdateDidToACell) {
  ViewRequest request = RequestFor(ViewKind::kUpdate);
  request.node = NodeId{20};
  const SubmapId submap = SmallLoop().node(NodeId{20}).first_submap;
  const ScanCells cells = CellsOfNode(SmallLoop(), submap, NodeId{20});
  const int num_before = 20 - SmallLoop().submap(submap).first_node.index;
  const ProbabilityGrid before = GridOfSubmap(SmallLoop(), submap, num_before);
  const ProbabilityGrid after = GridOfSubmap(SmallLoop(), submap, num_before + 1);
  const Inspector inspector = InspectorFor(request);
  for (const auto& [cell, what] :
       {std::pair(cells.hits.front(), "hit"), std::pair(cells.misses.front(), "miss"),
        std::pair(CellIndex{5000, 5000}, "untouched")}) {
    const auto odds = [cell = cell](const ProbabilityGrid& grid) {
      return grid.known(cell) ? fmt::format("{:.3g}", Odds(grid.probability(cell))) : "never seen";
    };
    const auto finding = inspector.WhatIsAt(1, CenterOf(cell, 0.05), 0.01);
    ASSERT_TRUE(finding);
    EXPECT_EQ(ValueOf(*finding, "by this scan"), what);
    EXPECT_EQ(ValueOf(*finding, "odds before"), odds(before));
    EXPECT_EQ(ValueOf(*finding, "odds after"), odds(after));
  }
}

TEST(InspectorTest, TellsTheProbabilityBehindAMatch) {
  ViewRequest request = RequestFor(ViewKind::kMatch);
  request.step = 140;
  const auto match = ReplayMatch(SmallLoop(), 140);
  const Vector point = match->submap_from_base * match->points.front();
  const auto finding = InspectorFor(request).WhatIsAt(0, point, 0.01);
  EXPECT_EQ(finding->submap, match->submap);
  EXPECT_EQ(ValueOf(*finding, "probability"),
            fmt::format("{:.3f}", match->grid.probability(CellOf(point, 0.05))));
}

TEST(InspectorTest, TellsOfEveryBlockThatIsShownItsBoundAndFate) {
  ViewRequest request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{122};
  request.submap = SubmapId{1};
  request.search.num_visits = 100;
  const auto search = ReplaySearch(SmallLoop(), SubmapId{1}, NodeId{122});
  const SearchPart part(search->trace, request.search);
  const auto levels = LevelsOf(part);
  const Inspector inspector = InspectorFor(request);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (const int node : levels[i].shown) {
      const Extent block = BlockOf(search->trace.nodes[node], search->trace.window);
      const auto finding = inspector.WhatIsAt(static_cast<int>(i) + 1, block.center(), 0.0);
      ASSERT_TRUE(finding);
      EXPECT_EQ(ValueOf(*finding, "bound"), fmt::format("{:.3f}", search->trace.nodes[node].bound));
      EXPECT_EQ(ValueOf(*finding, "height"), std::to_string(levels[i].height));
      EXPECT_EQ(ValueOf(*finding, "depth"),
                std::to_string(levels.front().height - levels[i].height));
      EXPECT_EQ(ValueOf(*finding, "fate"), part.WasPruned(node) ? "pruned by bound"
                                           : part.WasExpanded(node) && levels[i].height == 0
                                               ? "became the best"
                                           : part.WasExpanded(node) ? "expanded"
                                                                    : "not yet visited");
      EXPECT_EQ(ValueOf(*finding, "best score then").empty(), !part.WasDecided(node));
    }
  }
  EXPECT_FALSE(inspector.WhatIsAt(1, {100.0, 100.0}, 0.0));
}

TEST(InspectorTest, CountsOnlyThePosesOfABlockThatAreInTheWindow) {
  ViewRequest request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{122};
  request.submap = SubmapId{1};
  const auto search = ReplaySearch(SmallLoop(), SubmapId{1}, NodeId{122});
  const int last = search->trace.window.num_linear_steps;
  const auto& nodes = search->trace.nodes;
  const auto corner =
      std::max_element(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) {
        return a.offset.x + a.offset.y + 100 * a.height < b.offset.x + b.offset.y + 100 * b.height;
      });
  const int across = last - corner->offset.x + 1;
  ASSERT_LT(across, 1 << corner->height);  // it reaches beyond the window
  const Extent block = BlockOf(*corner, search->trace.window);
  const auto finding = InspectorFor(request).WhatIsAt(1, block.center(), 0.0);
  EXPECT_EQ(ValueOf(*finding, "poses"), std::to_string(across * across));
}

TEST(InspectorTest, TellsOfTheCellsInTheCloseUpOfASearch) {
  ViewRequest request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{122};
  request.submap = SubmapId{1};
  const auto search = ReplaySearch(SmallLoop(), SubmapId{1}, NodeId{122});
  const int close_up = static_cast<int>(LevelsOf(SearchPart(search->trace)).size()) + 1;
  const Eigen::Vector2d at_winner = search->result.submap_from_node * search->scan.returns.front();
  const auto finding = InspectorFor(request).WhatIsAt(close_up, at_winner, 0.0);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->submap, request.submap);
  request.search.height = 0;  // one level, and no close-up
  EXPECT_FALSE(InspectorFor(request).WhatIsAt(2, {100.0, 100.0}, 0.0));
}

TEST(InspectorTest, FindsTheFieldOfAnAngleInTheChart) {
  ViewRequest request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{122};
  request.submap = SubmapId{1};
  const Scene scene = BuildScene(SmallLoop(), request);
  const Box& chart = scene.panels.back().frame;
  const auto search = ReplaySearch(SmallLoop(), SubmapId{1}, NodeId{122});
  const SearchNode& winner = search->trace.nodes[search->trace.winner];
  const Extent field = FieldOf(winner, search->trace, chart.width / chart.height);
  DerivedCache cache(SmallLoop());
  const auto finding =
      Inspector(&cache, request, scene)
          .WhatIsAt(static_cast<int>(scene.panels.size()) - 1, field.center(), 0.0);
  ASSERT_TRUE(finding);
  EXPECT_EQ(ValueOf(*finding, "fate"), "became the best");
  EXPECT_EQ(ValueOf(*finding, "height"), "0");
}

}  // namespace
}  // namespace loopscope
