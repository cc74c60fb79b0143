// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/graph_export.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "core/slam/derive.h"
#include "tests/support/small_recording.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

struct Edge {
  int from = 0;
  int to = 0;
  Pose2 measurement;
  double information[6] = {};
};

struct Graph {
  std::map<int, Pose2> vertices;
  std::vector<Edge> edges;
  std::vector<int> fixed;
};

Graph ReadGraph(const std::string& path) {
  Graph graph;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    double x, y, rotation;
    if (kind == "VERTEX_SE2") {
      int id;
      words >> id >> x >> y >> rotation;
      graph.vertices[id] = Pose2(x, y, rotation);
    } else if (kind == "EDGE_SE2") {
      Edge edge;
      words >> edge.from >> edge.to >> x >> y >> rotation;
      edge.measurement = Pose2(x, y, rotation);
      for (double& information : edge.information) words >> information;
      graph.edges.push_back(edge);
    } else if (kind == "FIX") {
      graph.fixed.emplace_back();
      words >> graph.fixed.back();
    } else {
      ADD_FAILURE() << line;
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  return graph;
}

void ExpectNear(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR((a.translation - b.translation).norm(), 0.0, 1e-8);
  EXPECT_NEAR(NormalizeAngle(a.rotation - b.rotation), 0.0, 1e-8);
}

TEST(GraphExport, HasAVertexForEachSubmapAndNodeAndAnEdgeForEachConstraint) {
  const TemporaryFolder folder;
  const Recording recording = SmallRun(30).ToRecording();
  const MapState state = StateAfterStep(recording, 29);
  ExportGraph(recording, state, folder.Path("graph.g2o"));
  const Graph graph = ReadGraph(folder.Path("graph.g2o"));

  ASSERT_EQ(static_cast<int>(graph.vertices.size()), state.num_submaps + state.num_nodes);
  for (int i = 0; i < state.num_submaps; ++i) {
    ExpectNear(graph.vertices.at(i), state.global_from_submap[i]);
  }
  for (int i = 0; i < state.num_nodes; ++i) {
    ExpectNear(graph.vertices.at(state.num_submaps + i), state.global_from_node[i]);
  }
  EXPECT_EQ(graph.fixed, std::vector<int>{0});

  const std::vector<Constraint> constraints = ConstraintsOf(recording, state);
  ASSERT_EQ(graph.edges.size(), constraints.size());
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& constraint = constraints[i];
    const Edge& edge = graph.edges[i];
    EXPECT_EQ(edge.from, constraint.submap.index);
    EXPECT_EQ(edge.to, state.num_submaps + constraint.node.index);
    ExpectNear(edge.measurement, constraint.submap_from_node);
    const double translation = constraint.translation_weight * constraint.translation_weight;
    const double rotation = constraint.rotation_weight * constraint.rotation_weight;
    const double expected[6] = {translation, 0.0, 0.0, translation, 0.0, rotation};
    for (int j = 0; j < 6; ++j) EXPECT_NEAR(edge.information[j], expected[j], 1e-6 * expected[j]);
  }
}

TEST(GraphExport, LeavesOutLoopsThatAreOutliers) {
  Options options = CartographerPreset();
  options.pose_graph.optimization_problem.outliers = {1e-6, 1e-6};  // poses are random: all are
  const SmallRun run(30);
  Recording recording(run.log(), options);
  for (const SlamUpdate& update : run.updates()) recording.Append(update);
  const MapState state = StateAfterStep(recording, 29);
  const TemporaryFolder folder;
  ExportGraph(recording, state, folder.Path("graph.g2o"));
  const std::vector<Constraint> constraints = ConstraintsOf(recording, state);
  const auto num_intra = std::count_if(
      constraints.begin(), constraints.end(),
      [](const Constraint& constraint) { return constraint.tag == Constraint::Tag::kIntraSubmap; });
  ASSERT_LT(num_intra, static_cast<int>(constraints.size()));
  EXPECT_EQ(static_cast<int>(ReadGraph(folder.Path("graph.g2o")).edges.size()), num_intra);
}

}  // namespace
}  // namespace loopscope
