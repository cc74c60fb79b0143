// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/graph_solver.h"
#include "core/graph/graph_state.h"
#include "core/graph/loop_judge.h"
#include "core/graph/loop_search.h"
#include "core/graph/measured_drift.h"
#include "core/graph/near_pairs.h"
#include "core/graph/travel_graph.h"

namespace loopscope {

/// Nodes, submaps and what is known between them: finds loops in the background, and optimizes.
class PoseGraph {
 public:
  PoseGraph(const PoseGraphOptions& options, int num_threads);

  /// Adds the submap that the next node begins.
  void AddSubmap(const Pose2& local_from_submap);

  /// Adds a node with its INTRA_SUBMAP constraints, and considers it for loops with all finished
  /// submaps.
  void AddNode(const GraphNode& node, int step);

  /// Considers the submap for loops with all nodes that do not lie in it.
  void FinishSubmap(SubmapId id, const ProbabilityGrid& grid, int step);

  /// Whether enough nodes came since the last optimization.
  bool OptimizationIsDue() const;

  /// Waits for the loop searches and takes the loops found into the graph. All candidates that came
  /// up since the last call, by submap and node.
  std::vector<LoopCandidate> CollectLoops(int step);

  /// Optimizes all poses, which become the estimate, without loops that the others contradict, see
  /// OutlierOptions. Those that were left out before are tried again only where they agree, until
  /// loops have doubled. No longer than on the way: the next optimization goes on. In a large map
  /// only what is new moves, and what its loops tie it to, see PoseGraphOptions.
  GraphSolution Optimize();

  /// Like Optimize, but all poses move, until the cost falls no more.
  GraphSolution OptimizeFully();

  /// Like OptimizeFully, but all loops that were left out are tried again.
  GraphSolution OptimizeAnew();

  /// Of their windows that searches take since the last optimization.
  const DriftShare& drift_share() const { return drift_share_; }

  /// After the final optimization: searches all submaps of one place that no loop ties, and takes
  /// the loops found into the graph. All candidates, by submap and node.
  std::vector<LoopCandidate> LookLast(int step);

 private:
  bool SearchesLoops() const { return options_.optimize_every_n_nodes > 0; }
  /// Adds the way from the node before to the travel graph.
  void AddWayTo(NodeId id);
  /// Local SLAM and odometry between the node and the one before it.
  void AddConsecutive(NodeId id);
  double MinLoopScoreOf(SubmapId id, const ProbabilityGrid& grid) const;
  /// Searches submaps of the same place that no loop ties.
  void LookAgain(int step);
  SubmapPlace PlaceOf(SubmapId id) const;
  /// Judges the candidates that were searched, and takes those accepted into the graph.
  void TakeIn(std::vector<LoopCandidate>* candidates, int step);
  GraphProblem Problem() const;
  /// Of constraints_ so many whose verdict stands. None when loops have doubled since all were
  /// judged, which is taken as done: often enough to correct a wrong choice, so seldom that the
  /// cost of a loop stays bounded.
  std::size_t BeginJudging();
  /// The first submap to move if what is old is held: before what came since the last optimization,
  /// and before what its loops tie it to, if that is much. Else submap 0.
  SubmapId FirstToMove() const;
  /// Of the first `num_judged` of constraints_ only those that were left out may be left out again.
  GraphSolution SolveFully(std::size_t num_judged);
  /// Makes the solution, rounded as it is recorded, the state.
  GraphSolution Adopt(GraphSolution solution);
  /// Searches neighbours of the loops that stand alone, where those have them.
  void CheckLoneLoops(std::vector<LoopCandidate>* candidates);
  void SearchWhereLoopHasIt(const LoopCandidate& loop, LoopCandidate* pair);
  /// Notes what drift the loops accepted took.
  void MeasureDrift(const std::vector<LoopCandidate>& candidates);
  LoopGate GateOf(SubmapId submap, const Pose2& submap_from_node_guess, double way) const;
  void ConsiderNearSubmaps(NodeId node, int step);
  void ConsiderNearNodes(SubmapId submap, int step);
  /// Sets off a loop search for the pair if it is near enough; `way` [m] from TravelGraph.
  void Consider(SubmapId submap, NodeId node, double way, int step);
  /// The pair as it comes up now; kTooFar unless it is near enough.
  LoopCandidate CandidateOf(SubmapId submap, NodeId node, double way, int step) const;

  PoseGraphOptions options_;
  GraphState graph_;
  std::size_t num_looked_at_ = 0;  ///< finished submaps whose own pairs were collected
  double counted_way_ = 0.0;       ///< [m] to the last node, as CountedWay has it
  LoopJudge loop_judge_;
  MeasuredDrift measured_drift_;
  DriftShare drift_share_;  ///< to search in
  SecondLook second_look_;
  TravelGraph travel_graph_;
  Pose2 global_from_local_;
  NearPairs near_pairs_;
  std::vector<Constraint> constraints_;
  std::vector<ConsecutiveNodes> consecutive_nodes_;
  std::size_t num_judged_ = 0;  ///< of constraints_: those of the last optimization
  std::size_t num_loops_when_all_were_judged_ = 0;
  int num_nodes_since_optimization_ = 0;
  LoopSearch loop_search_;
};

}  // namespace loopscope
