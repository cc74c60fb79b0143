// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/pose_graph.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/graph/loop_gate.h"
#include "core/graph/moving_part.h"
#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

/// Loops near the bound could come and go for ever.
constexpr int kMaxNumFinalRounds = 10;

/// Before what is new, so that its loops find something that gives way.
constexpr int kNumSubmapsThatYield = 20;

}  // namespace

PoseGraph::PoseGraph(const PoseGraphOptions& options, int num_threads)
    : options_(options),
      loop_judge_(options.constraint_builder.consistency, options.optimization_problem.outliers),
      measured_drift_(options.constraint_builder.measured_drift,
                      options.optimization_problem.outliers),
      second_look_(options.constraint_builder.second_look),
      near_pairs_(MaxGateDistance(options.constraint_builder)),
      loop_search_(options.constraint_builder, num_threads) {}

void PoseGraph::AddSubmap(const Pose2& local_from_submap) {
  graph_.submaps.push_back(
      {local_from_submap, NodeId{static_cast<int>(graph_.nodes.size())}, 0, {}, 0.0, 0.0, {}});
  graph_.global_from_submap.push_back(global_from_local_ * local_from_submap);
}

void PoseGraph::AddNode(const GraphNode& node, int step) {
  const NodeId id{static_cast<int>(graph_.nodes.size())};
  graph_.nodes.push_back(node);
  graph_.global_from_node.push_back(global_from_local_ * node.local_from_node);
  near_pairs_.AddNode(id, graph_);
  AddWayTo(id);
  for (int i = 0; i < node.num_submaps; ++i) {
    const SubmapId submap{node.first_submap.index + i};
    GraphSubmap& data = graph_.submaps[submap.index];
    const Pose2 submap_from_node = data.local_from_submap.Inverse() * node.local_from_node;
    data.node_box.extend(submap_from_node.translation);
    ++data.num_nodes;
    constraints_.push_back({submap, id, submap_from_node, options_.matcher_translation_weight,
                            options_.matcher_rotation_weight, Constraint::Tag::kIntraSubmap});
  }
  AddConsecutive(id);
  ++num_nodes_since_optimization_;
  ConsiderNearSubmaps(id, step);
}

void PoseGraph::ConsiderNearSubmaps(NodeId node, int step) {
  const std::vector<double>& ways = travel_graph_.WaysFrom(graph_.node(node).first_submap);
  for (const int submap : near_pairs_.SubmapsNear(node, graph_)) {
    Consider(SubmapId{submap}, node, ways[submap], step);
  }
}

void PoseGraph::ConsiderNearNodes(SubmapId submap, int step) {
  const std::vector<double>& ways = travel_graph_.WaysFrom(submap);
  for (const int node : near_pairs_.NodesNear(submap, graph_)) {
    Consider(submap, NodeId{node}, ways[graph_.nodes[node].first_submap.index], step);
  }
}

void PoseGraph::AddWayTo(NodeId id) {
  const double gap = id.index == 0 ? 0.0
                                   : (graph_.node(id).local_from_node.translation -
                                      graph_.nodes[id.index - 1].local_from_node.translation)
                                         .norm();
  graph_.node_ways.push_back(id.index == 0 ? 0.0 : graph_.node_ways.back() + gap);
  counted_way_ += CountedWay(gap, graph_.node(id).matched_nowhere, options_.constraint_builder);
  if (graph_.submaps.back().first_node != id) return;
  graph_.submaps.back().counted_way = counted_way_;
  const std::size_t num_submaps = graph_.submaps.size();
  const double way_before = num_submaps < 2 ? 0.0 : graph_.submaps[num_submaps - 2].counted_way;
  travel_graph_.AddSubmap(counted_way_ - way_before);
}

void PoseGraph::AddConsecutive(NodeId id) {
  if (id.index == 0) return;
  const NodeId before{id.index - 1};
  const auto measured = [&](NodeId node) {
    const GraphNode& data = graph_.node(node);
    return MeasuredNode{node, data.local_from_node, data.odom_from_node};
  };
  for (const ConsecutiveNodes& term :
       RelateConsecutive(measured(before), measured(id), options_.optimization_problem)) {
    consecutive_nodes_.push_back(term);
  }
}

void PoseGraph::FinishSubmap(SubmapId id, const ProbabilityGrid& grid, int step) {
  graph_.submaps[id.index].min_loop_score = MinLoopScoreOf(id, grid);
  graph_.submaps[id.index].seen.emplace(grid);
  loop_search_.AddSubmap(id, grid);
  near_pairs_.AddFinishedSubmap(id, graph_);
  ConsiderNearNodes(id, step);
}

double PoseGraph::MinLoopScoreOf(SubmapId id, const ProbabilityGrid& grid) const {
  const GraphSubmap& submap = graph_.submap(id);
  const Pose2 submap_from_local = submap.local_from_submap.Inverse();
  std::vector<PlacedScan> own_nodes;
  for (int i = 0; i < submap.num_nodes; ++i) {
    const GraphNode& node = graph_.nodes[submap.first_node.index + i];
    own_nodes.push_back({&node.scan->returns, submap_from_local * node.local_from_node});
  }
  return MinLoopScore(own_nodes, grid, options_.constraint_builder);
}

void PoseGraph::Consider(SubmapId submap, NodeId node, double way, int step) {
  const GraphNode& data = graph_.node(node);
  if (!SearchesLoops() || data.scan->returns.empty() || data.LiesIn(submap)) return;
  const LoopCandidate candidate = CandidateOf(submap, node, way, step);
  if (candidate.verdict == Verdict::kTooFar) return;
  const LoopCandidate narrowed = WithDriftShare(candidate, drift_share_);
  const double gap =
      node.index == 0 ? 0.0 : graph_.node_ways[node.index] - graph_.node_ways[node.index - 1];
  loop_search_.Consider(
      narrowed, data.scan,
      SamplingShare(narrowed.linear_search_window, gap, options_.constraint_builder));
}

LoopCandidate PoseGraph::CandidateOf(SubmapId submap, NodeId node, double way, int step) const {
  const Pose2 guess = graph_.SubmapFromNode(submap, node);
  return AtGate(GateOf(submap, guess, way), submap, node, step, guess,
                graph_.submap(submap).min_loop_score);
}

LoopGate PoseGraph::GateOf(SubmapId submap, const Pose2& submap_from_node_guess, double way) const {
  return EvaluateLoopGate(submap_from_node_guess, graph_.submap(submap).node_box, way,
                          options_.constraint_builder);
}

bool PoseGraph::OptimizationIsDue() const {
  const double share = options_.optimize_every_share * static_cast<double>(graph_.nodes.size());
  const double min_num_new = std::min<double>(share, options_.optimize_at_latest_after_n_nodes);
  return SearchesLoops() && num_nodes_since_optimization_ >= options_.optimize_every_n_nodes &&
         num_nodes_since_optimization_ >= min_num_new;
}

std::vector<LoopCandidate> PoseGraph::CollectLoops(int step) {
  LookAgain(step);
  std::vector<LoopCandidate> candidates = loop_search_.Collect();
  CheckLoneLoops(&candidates);
  TakeIn(&candidates, step);
  return candidates;
}

void PoseGraph::TakeIn(std::vector<LoopCandidate>* candidates, int step) {
  loop_judge_.RejectInconsistent(graph_, candidates);
  MeasureDrift(*candidates);
  for (LoopCandidate& candidate : *candidates) {
    candidate.applied_step = step;
    if (candidate.verdict != Verdict::kAccepted) continue;
    loop_judge_.Believe(graph_, candidate);
    constraints_.push_back(ToConstraint(candidate, options_.constraint_builder));
    const GraphNode& node = graph_.node(candidate.node);
    travel_graph_.AddLoop(candidate.submap, node.first_submap);
    for (int i = 0; i < node.num_submaps; ++i) {
      second_look_.Tie(candidate.submap, SubmapId{node.first_submap.index + i});
    }
  }
}

void PoseGraph::MeasureDrift(const std::vector<LoopCandidate>& candidates) {
  for (const LoopCandidate& loop : candidates) {
    if (loop.verdict != Verdict::kAccepted) continue;
    const Pose2 guess = graph_.SubmapFromNode(loop.submap, loop.node);
    const SubmapId node_submap = graph_.node(loop.node).first_submap;
    const double way = travel_graph_.WaysFrom(loop.submap)[node_submap.index];
    measured_drift_.Note(
        ToConstraint(loop, options_.constraint_builder),
        DriftShareOf(guess, loop.submap_from_node, GateOf(loop.submap, guess, way)));
  }
}

void PoseGraph::LookAgain(int step) {
  if (!SearchesLoops()) return;
  std::vector<SubmapPlace> places;
  for (std::size_t i = 0; i < num_looked_at_; ++i) {
    places.push_back(PlaceOf(near_pairs_.finished_submaps()[i]));
  }
  std::map<SubmapId, std::vector<double>> ways;
  for (const auto& [submap, node] :
       second_look_.Choose(places, graph_.global_from_node, graph_.node_ways)) {
    const GraphNode& data = graph_.node(node);
    if (data.scan->returns.empty()) continue;
    std::vector<double>& ways_from_submap = ways[submap];
    if (ways_from_submap.empty()) ways_from_submap = travel_graph_.WaysFrom(submap);
    const LoopCandidate candidate =
        CandidateOf(submap, node, ways_from_submap[data.first_submap.index], step);
    if (candidate.verdict != Verdict::kTooFar) {
      loop_search_.Begin(WithDriftShare(candidate, drift_share_), data.scan);
    }
  }
  num_looked_at_ = near_pairs_.finished_submaps().size();
}

std::vector<LoopCandidate> PoseGraph::LookLast(int step) {
  const LastLookOptions& options = options_.constraint_builder.last_look;
  if (!SearchesLoops()) return {};
  std::vector<SubmapPlace> places;
  for (SubmapId id{0}; id.index < static_cast<int>(graph_.submaps.size()); ++id.index) {
    places.push_back(PlaceOf(id));
  }
  for (const auto& [submap, node] : second_look_.ChooseOfUntied(
           places, graph_.global_from_node, graph_.node_ways, options.num_nodes)) {
    const GraphNode& data = graph_.node(node);
    if (data.scan->returns.empty()) continue;
    LoopCandidate candidate = CandidateOf(submap, node, 0.0, step);  // no drift: the least window
    if (candidate.verdict == Verdict::kTooFar) continue;
    candidate.last_look = true;
    loop_search_.Begin(candidate, data.scan);
  }
  std::vector<LoopCandidate> candidates = loop_search_.Collect();
  TakeIn(&candidates, step);
  return candidates;
}

SubmapPlace PoseGraph::PlaceOf(SubmapId id) const {
  const GraphSubmap& data = graph_.submap(id);
  return {id,
          graph_.global_from_submap[id.index],
          data.node_box,
          data.first_node,
          data.num_nodes,
          data.seen ? &*data.seen : nullptr};
}

void PoseGraph::CheckLoneLoops(std::vector<LoopCandidate>* candidates) {
  const LoopConsistencyOptions& options = options_.constraint_builder.consistency;
  if (options.num_checked_neighbors == 0) return;
  std::map<SubmapId, std::map<NodeId, LoopCandidate*>> left_out;
  for (LoopCandidate& candidate : *candidates) {
    if (candidate.verdict != Verdict::kNotSampled) continue;
    left_out[candidate.submap].emplace(candidate.node, &candidate);
  }
  for (const LoopCandidate* loop : loop_judge_.LoneLoops(graph_, *candidates)) {
    std::map<NodeId, LoopCandidate*>& pairs = left_out[loop->submap];
    std::vector<NodeId> nodes;
    for (const auto& [node, pair] : pairs) nodes.push_back(node);
    for (const NodeId node : NeighborsToCheck(loop->node, nodes, graph_.node_ways, options)) {
      SearchWhereLoopHasIt(*loop, pairs.at(node));
      pairs.erase(node);
    }
  }
  loop_search_.Wait();
}

void PoseGraph::SearchWhereLoopHasIt(const LoopCandidate& loop, LoopCandidate* pair) {
  const GraphNode& node = graph_.node(pair->node);
  const BranchAndBoundOptions& least = options_.constraint_builder.fast_correlative_scan_matcher;
  pair->submap_from_node_guess = loop.submap_from_node *
                                 graph_.node(loop.node).local_from_node.Inverse() *
                                 node.local_from_node;
  pair->linear_search_window = least.linear_search_window;
  pair->angular_search_window = least.angular_search_window;
  pair->min_score = graph_.submap(loop.submap).min_loop_score;
  loop_search_.BeginInPlace(pair, node.scan);
}

GraphSolution PoseGraph::Optimize() {
  const OptimizationProblemOptions& options = options_.optimization_problem;
  const std::size_t num_judged = BeginJudging();
  const MovingPart part(graph_, constraints_, consecutive_nodes_,
                        num_judged > 0 ? FirstToMove() : SubmapId{0}, options);
  const GraphSolution solution = SolveGraphWithoutOutliers(
      part.problem(), part.NumAmongFirst(num_judged), options,
      {options.max_num_iterations, options.function_tolerance}, options.outliers.max_num_rounds);
  return Adopt(part.Completed(solution, graph_));
}

GraphSolution PoseGraph::OptimizeFully() { return SolveFully(BeginJudging()); }

GraphSolution PoseGraph::OptimizeAnew() { return SolveFully(0); }

GraphSolution PoseGraph::SolveFully(std::size_t num_judged) {
  return Adopt(SolveGraphWithoutOutliers(Problem(), num_judged, options_.optimization_problem,
                                         {options_.max_num_final_iterations}, kMaxNumFinalRounds));
}

std::size_t PoseGraph::BeginJudging() {
  const std::size_t num_believed = loop_judge_.num_believed();
  if (num_believed == 0 || num_believed < 2 * num_loops_when_all_were_judged_) return num_judged_;
  num_loops_when_all_were_judged_ = num_believed;
  return 0;
}

SubmapId PoseGraph::FirstToMove() const {
  int first_moving = static_cast<int>(graph_.submaps.size()) - 1;
  for (std::size_t i = num_judged_; i < constraints_.size(); ++i) {
    const Constraint& c = constraints_[i];
    const SubmapId node_submap = graph_.node(c.node).first_submap;
    first_moving = std::min({first_moving, c.submap.index, node_submap.index});
  }
  first_moving = std::max(first_moving - kNumSubmapsThatYield, 0);
  const int num_held_nodes = graph_.submaps[first_moving].first_node.index;
  const bool holds =
      options_.min_num_held_nodes > 0 && num_held_nodes >= options_.min_num_held_nodes;
  return SubmapId{holds ? first_moving : 0};
}

GraphProblem PoseGraph::Problem() const {
  return {graph_.global_from_submap, graph_.global_from_node, constraints_, consecutive_nodes_};
}

GraphSolution PoseGraph::Adopt(GraphSolution solution) {
  for (Pose2& pose : solution.global_from_submap) pose = Rounded(pose);
  for (Pose2& pose : solution.global_from_node) pose = Rounded(pose);
  graph_.global_from_submap = solution.global_from_submap;
  graph_.global_from_node = solution.global_from_node;
  global_from_local_ =
      graph_.global_from_submap.back() * graph_.submaps.back().local_from_submap.Inverse();
  near_pairs_.Renew(graph_);
  drift_share_ = measured_drift_.Predict(graph_);
  num_nodes_since_optimization_ = 0;
  num_judged_ = constraints_.size();
  return solution;
}

}  // namespace loopscope
