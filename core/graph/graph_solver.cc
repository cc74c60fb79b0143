// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/graph_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "core/graph/block_system.h"
#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

// As Ceres has them by default.
constexpr double kFirstRadius = 1e4;
constexpr double kMaxRadius = 1e16;
constexpr double kMinRadius = 1e-32;
constexpr double kMinGain = 1e-3;
constexpr double kMinDamping = 1e-6;
constexpr double kMaxDamping = 1e32;

constexpr int kHeld = -1;  ///< submap 0, which is no unknown

/// A term of eq. 4: how j was seen from i.
struct Term {
  int i = kHeld;  ///< unknowns: submaps from the second on, then nodes
  int j = kHeld;
  Pose2 i_from_j;
  SpaInformation information;
  bool robust = false;  ///< with Huber's loss
  int coupling = -1;    ///< of the block system, at (j, i); -1 if i is held
};

/// Each with its rotation as a matrix, which is needed more often than it changes.
class Poses {
 public:
  Poses(const Pose2& held, std::vector<Pose2> unknowns)
      : held_(held), held_rotation_(held.RotationMatrix()), unknowns_(std::move(unknowns)) {
    rotations_.reserve(unknowns_.size());
    for (const Pose2& pose : unknowns_) rotations_.push_back(pose.RotationMatrix());
  }

  const Pose2& held() const { return held_; }
  const std::vector<Pose2>& unknowns() const { return unknowns_; }
  const Pose2& at(int unknown) const { return unknown == kHeld ? held_ : unknowns_[unknown]; }
  const Eigen::Matrix2d& rotation(int unknown) const {
    return unknown == kHeld ? held_rotation_ : rotations_[unknown];
  }

 private:
  Pose2 held_;
  Eigen::Matrix2d held_rotation_;
  std::vector<Pose2> unknowns_;
  std::vector<Eigen::Matrix2d> rotations_;
};

/// Eq. 4 as a least squares problem, and the quadratic that it is near some poses:
/// H = J^T W J, g = J^T W e, where e are the errors of eq. 5, and W holds the weights, with those
/// by which Huber's loss stands for a square there.
class LeastSquares {
 public:
  LeastSquares(const GraphProblem& graph, double huber_scale)
      : num_submaps_(static_cast<int>(graph.global_from_submap.size())),
        num_unknowns_(num_submaps_ - 1 + static_cast<int>(graph.global_from_node.size())),
        huber_scale_(huber_scale),
        terms_(TermsOf(graph)),
        system_(MakeSystem()),
        gradient_(3 * num_unknowns_),
        diagonal_(3 * num_unknowns_) {}

  /// Half the sum of eq. 4.
  double Cost(const Poses& poses) const {
    double cost = 0.0;
    for (const Term& term : terms_) {
      const double square = term.information.SquareOf(ErrorOf(term, poses));
      const bool is_linear = term.robust && square > huber_scale_ * huber_scale_;
      cost += 0.5 * (is_linear ? huber_scale_ * (2.0 * std::sqrt(square) - huber_scale_) : square);
    }
    return cost;
  }

  void Linearize(const Poses& poses) {
    system_.SetZero();
    gradient_.setZero();
    for (const Term& term : terms_) {
      const Eigen::Vector3d error = ErrorOf(term, poses);
      SpaInformation information = term.information;
      if (term.robust) {
        const double weight = HuberWeight(information.SquareOf(error), huber_scale_);
        information.translation *= weight;
        information.rotation *= weight;
      }
      const SpaQuadratic quadratic(error, poses.at(term.i), poses.at(term.j), information);
      AddUnknown(term.i, quadratic.ii, quadratic.by_i);
      AddUnknown(term.j, quadratic.jj, quadratic.by_j);
      if (term.coupling >= 0) system_.coupling(term.coupling) += quadratic.ji;
    }
    for (int i = 0; i < num_unknowns_; ++i) {
      diagonal_.segment<3>(3 * i) = system_.diagonal(i).diagonal();
    }
  }

  /// After Linearize: the g and the diagonal of H.
  const Eigen::VectorXd& gradient() const { return gradient_; }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  BlockSystem& system() { return system_; }

  int unknown(SubmapId id) const { return id.index == 0 ? kHeld : id.index - 1; }
  int unknown(NodeId id) const { return num_submaps_ - 1 + id.index; }

 private:
  std::vector<Term> TermsOf(const GraphProblem& graph) const {
    std::vector<Term> terms;
    terms.reserve(graph.constraints.size() + graph.consecutive_nodes.size());
    const auto add = [&](int i, int j, const Pose2& i_from_j, double translation_weight,
                         double rotation_weight, bool robust) {
      const SpaInformation information{translation_weight * translation_weight,
                                       rotation_weight * rotation_weight};
      terms.push_back({i, j, i_from_j, information, robust, -1});
    };
    for (const Constraint& c : graph.constraints) {
      add(unknown(c.submap), unknown(c.node), c.submap_from_node, c.translation_weight,
          c.rotation_weight, c.tag == Constraint::Tag::kInterSubmap);
    }
    for (const ConsecutiveNodes& c : graph.consecutive_nodes) {
      add(unknown(c.first), unknown(c.second), c.first_from_second, c.translation_weight,
          c.rotation_weight, false);
    }
    return terms;
  }

  /// Tells the terms their couplings.
  BlockSystem MakeSystem() {
    std::vector<Term*> coupled;
    for (Term& term : terms_) {
      assert(term.j > term.i);
      if (term.i != kHeld) coupled.push_back(&term);
    }
    std::sort(coupled.begin(), coupled.end(), [](const Term* a, const Term* b) {
      return std::pair(a->j, a->i) < std::pair(b->j, b->i);
    });
    std::vector<BlockSystem::Coupling> couplings;
    for (Term* term : coupled) {
      const bool is_new = couplings.empty() || couplings.back().row != term->j ||
                          couplings.back().column != term->i;
      if (is_new) couplings.push_back({term->j, term->i});
      term->coupling = static_cast<int>(couplings.size()) - 1;
    }
    return BlockSystem(num_unknowns_, std::move(couplings));
  }

  static Eigen::Vector3d ErrorOf(const Term& term, const Poses& poses) {
    return GlobalSpaError(term.i_from_j, poses.at(term.i), poses.rotation(term.i),
                          poses.at(term.j));
  }

  void AddUnknown(int unknown, const Eigen::Matrix3d& block, const Eigen::Vector3d& gradient) {
    if (unknown == kHeld) return;
    system_.diagonal(unknown) += block;
    gradient_.segment<3>(3 * unknown) += gradient;
  }

  int num_submaps_;
  int num_unknowns_;
  double huber_scale_;
  std::vector<Term> terms_;
  BlockSystem system_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd diagonal_;
};

Poses StartOf(const GraphProblem& graph) {
  std::vector<Pose2> unknowns(graph.global_from_submap.begin() + 1, graph.global_from_submap.end());
  unknowns.insert(unknowns.end(), graph.global_from_node.begin(), graph.global_from_node.end());
  return Poses(graph.global_from_submap.front(), std::move(unknowns));
}

Poses Moved(const Poses& poses, const Eigen::VectorXd& step) {
  std::vector<Pose2> moved = poses.unknowns();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i].translation += step.segment<2>(3 * i);
    moved[i].rotation = NormalizeAngle(moved[i].rotation + step[3 * i + 2]);
  }
  return Poses(poses.held(), std::move(moved));
}

GraphSolution ToSolution(const Poses& poses, int num_submaps, int num_iterations,
                         double initial_cost, double final_cost) {
  const std::vector<Pose2>& unknowns = poses.unknowns();
  const auto first_node = unknowns.begin() + (num_submaps - 1);
  GraphSolution solution{
      {poses.held()}, {first_node, unknowns.end()}, num_iterations, initial_cost, final_cost};
  solution.global_from_submap.insert(solution.global_from_submap.end(), unknowns.begin(),
                                     first_node);
  return solution;
}

/// How far steps are trusted: as Levenberg and Marquardt have it, in the form of Ceres.
class TrustRegion {
 public:
  bool IsTooSmall() const { return radius_ < kMinRadius; }
  Eigen::VectorXd DampingOf(const Eigen::VectorXd& diagonal) const {
    return diagonal.cwiseMax(kMinDamping).cwiseMin(kMaxDamping) / radius_;
  }
  /// `gain` is the share of the expected gain that a step brought.
  void Grow(double gain) {
    radius_ /= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3));
    radius_ = std::min(radius_, kMaxRadius);
    shrink_ = 2.0;
  }
  void Shrink() {
    radius_ /= shrink_;
    shrink_ *= 2.0;
  }

 private:
  double radius_ = kFirstRadius;
  double shrink_ = 2.0;
};

/// A step from the poses that `least_squares` is linearized at.
struct Trial {
  Poses poses;
  double cost = 0.0;
  double gain = 0.0;  ///< share of the gain that the quadratic promised
};

/// Nothing if the damped quadratic has no minimum.
std::optional<Trial> TryStep(LeastSquares* least_squares, const Poses& poses, double cost,
                             const TrustRegion& region) {
  const Eigen::VectorXd damping = region.DampingOf(least_squares->diagonal());
  if (!least_squares->system().Factorize(damping)) return std::nullopt;
  const Eigen::VectorXd& gradient = least_squares->gradient();
  const Eigen::VectorXd step = -least_squares->system().Solve(gradient);
  const double promised = 0.5 * (step.dot(damping.cwiseProduct(step)) - step.dot(gradient));
  Trial trial{Moved(poses, step), 0.0, 0.0};
  trial.cost = least_squares->Cost(trial.poses);
  trial.gain = promised > 0.0 ? (cost - trial.cost) / promised : 0.0;
  return trial;
}

/// The inverse of H at the block of `unknown`; nothing if H is singular but for rounding.
std::optional<Eigen::Matrix3d> CovarianceOf(const GraphProblem& problem, int unknown,
                                            LeastSquares* least_squares) {
  constexpr double kMaxResidual = 1e-3;
  least_squares->Linearize(StartOf(problem));
  BlockSystem& system = least_squares->system();
  const Eigen::Index size = least_squares->gradient().size();
  if (!system.Factorize(Eigen::VectorXd::Zero(size))) return std::nullopt;
  Eigen::Matrix3d covariance;
  for (int i = 0; i < 3; ++i) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, 3 * unknown + i);
    const Eigen::VectorXd column = system.Solve(unit);
    if (!((system.Multiply(column) - unit).norm() < kMaxResidual)) return std::nullopt;
    covariance.col(i) = column.segment<3>(3 * unknown);
  }
  return covariance;
}

}  // namespace

GraphSolution Continued(const GraphSolution& first, GraphSolution next) {
  next.num_iterations += first.num_iterations;
  next.initial_cost = first.initial_cost;
  return next;
}

GraphSolution SolveGraph(const GraphProblem& problem, const OptimizationProblemOptions& options,
                         const SolverLimits& limits) {
  assert(!problem.global_from_submap.empty());
  LeastSquares least_squares(problem, options.huber_scale);
  Poses poses = StartOf(problem);
  const double initial_cost = least_squares.Cost(poses);
  double cost = initial_cost;
  TrustRegion region;
  least_squares.Linearize(poses);
  int num_iterations = 0;
  for (bool done = false; !done && num_iterations < limits.max_num_iterations; ++num_iterations) {
    std::optional<Trial> trial = TryStep(&least_squares, poses, cost, region);
    if (!trial || !(trial->gain > kMinGain)) {
      region.Shrink();
      done = region.IsTooSmall() ||
             (trial && std::abs(cost - trial->cost) <= limits.function_tolerance * cost);
      continue;
    }
    region.Grow(trial->gain);
    done = cost - trial->cost <= limits.function_tolerance * cost;
    cost = trial->cost;
    poses = std::move(trial->poses);
    if (!done) least_squares.Linearize(poses);
  }
  return ToSolution(poses, static_cast<int>(problem.global_from_submap.size()), num_iterations,
                    initial_cost, cost);
}

std::optional<Eigen::Matrix3d> CovarianceOfNode(const GraphProblem& problem,
                                                const OptimizationProblemOptions& options,
                                                NodeId node) {
  LeastSquares least_squares(problem, options.huber_scale);
  return CovarianceOf(problem, least_squares.unknown(node), &least_squares);
}

std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const GraphProblem& problem,
                                                  const OptimizationProblemOptions& options,
                                                  SubmapId submap) {
  if (submap.index == 0) return Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  LeastSquares least_squares(problem, options.huber_scale);
  return CovarianceOf(problem, least_squares.unknown(submap), &least_squares);
}

}  // namespace loopscope
