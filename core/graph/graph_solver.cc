// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/graph_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "core/graph/block_system.h"
#include "core/graph/graph_unknowns.h"
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

/// A term of eq. 4: how j was seen from i.
struct Term {
  int i = 0;  ///< poses, see GraphPoses
  int j = 0;
  Pose2 i_from_j;
  SpaInformation information;
  bool robust = false;  ///< with Huber's loss
  int unknown_i = GraphUnknowns::kHeld;
  int unknown_j = GraphUnknowns::kHeld;
  int coupling = -1;  ///< of the block system, at both unknowns; -1 if one is held
};

/// Eq. 4 as a least squares problem, and the quadratic that it is near some poses:
/// H = J^T W J, g = J^T W e, where e are the errors of eq. 5, and W holds the weights, with those
/// by which Huber's loss stands for a square there.
class LeastSquares {
 public:
  LeastSquares(const GraphProblem& graph, double huber_scale)
      : unknowns_(graph),
        huber_scale_(huber_scale),
        terms_(TermsOf(graph)),
        held_terms_(SplitOffHeld()),
        system_(MakeSystem()),
        gradient_(3 * unknowns_.count()),
        diagonal_(3 * unknowns_.count()) {}

  /// Half the sum of eq. 4, of the terms with an unknown.
  double Cost(const GraphPoses& poses) const { return CostOf(terms_, poses); }
  /// Of the others.
  double HeldCost(const GraphPoses& poses) const { return CostOf(held_terms_, poses); }

  void Linearize(const GraphPoses& poses) {
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
      AddUnknown(term.unknown_i, quadratic.ii, quadratic.by_i);
      AddUnknown(term.unknown_j, quadratic.jj, quadratic.by_j);
      if (term.coupling >= 0) system_.coupling(term.coupling) += quadratic.ji;
    }
    for (int i = 0; i < unknowns_.count(); ++i) {
      diagonal_.segment<3>(3 * i) = system_.diagonal(i).diagonal();
    }
  }

  /// After Linearize: the g and the diagonal of H.
  const Eigen::VectorXd& gradient() const { return gradient_; }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  BlockSystem& system() { return system_; }

  const GraphUnknowns& unknowns() const { return unknowns_; }

 private:
  std::vector<Term> TermsOf(const GraphProblem& graph) const {
    std::vector<Term> terms;
    terms.reserve(graph.constraints.size() + graph.consecutive_nodes.size());
    const auto add = [&](auto i, NodeId j, const Pose2& i_from_j, double translation_weight,
                         double rotation_weight, bool robust) {
      terms.push_back({unknowns_.pose(i), unknowns_.pose(j), i_from_j,
                       SpaInformation::OfWeights(translation_weight, rotation_weight), robust,
                       unknowns_.of(i), unknowns_.of(j), -1});
    };
    for (const Constraint& c : graph.constraints) {
      add(c.submap, c.node, c.submap_from_node, c.translation_weight, c.rotation_weight,
          c.tag == Constraint::Tag::kInterSubmap);
    }
    for (const ConsecutiveNodes& c : graph.consecutive_nodes) {
      add(c.first, c.second, c.first_from_second, c.translation_weight, c.rotation_weight, false);
    }
    return terms;
  }

  /// Takes the terms without an unknown out of terms_.
  std::vector<Term> SplitOffHeld() {
    const auto held = std::stable_partition(terms_.begin(), terms_.end(), [](const Term& term) {
      return term.unknown_i != GraphUnknowns::kHeld || term.unknown_j != GraphUnknowns::kHeld;
    });
    std::vector<Term> held_terms(held, terms_.end());
    terms_.erase(held, terms_.end());
    return held_terms;
  }

  double CostOf(const std::vector<Term>& terms, const GraphPoses& poses) const {
    double cost = 0.0;
    for (const Term& term : terms) {
      const double square = term.information.SquareOf(ErrorOf(term, poses));
      cost += term.robust ? HuberCost(square, huber_scale_) : 0.5 * square;
    }
    return cost;
  }

  /// Tells the terms their couplings.
  BlockSystem MakeSystem() {
    std::vector<Term*> coupled;
    for (Term& term : terms_) {
      if (term.unknown_i == GraphUnknowns::kHeld || term.unknown_j == GraphUnknowns::kHeld) {
        continue;
      }
      assert(term.unknown_j > term.unknown_i);
      coupled.push_back(&term);
    }
    std::sort(coupled.begin(), coupled.end(), [](const Term* a, const Term* b) {
      return std::pair(a->unknown_j, a->unknown_i) < std::pair(b->unknown_j, b->unknown_i);
    });
    std::vector<BlockSystem::Coupling> couplings;
    for (Term* term : coupled) {
      const bool is_new = couplings.empty() || couplings.back().row != term->unknown_j ||
                          couplings.back().column != term->unknown_i;
      if (is_new) couplings.push_back({term->unknown_j, term->unknown_i});
      term->coupling = static_cast<int>(couplings.size()) - 1;
    }
    return BlockSystem(unknowns_.count(), std::move(couplings));
  }

  static Eigen::Vector3d ErrorOf(const Term& term, const GraphPoses& poses) {
    return GlobalSpaError(term.i_from_j, poses.at(term.i), poses.rotation(term.i),
                          poses.at(term.j));
  }

  void AddUnknown(int unknown, const Eigen::Matrix3d& block, const Eigen::Vector3d& gradient) {
    if (unknown == GraphUnknowns::kHeld) return;
    system_.diagonal(unknown) += block;
    gradient_.segment<3>(3 * unknown) += gradient;
  }

  GraphUnknowns unknowns_;
  double huber_scale_;
  std::vector<Term> terms_;       ///< those with an unknown
  std::vector<Term> held_terms_;  ///< the others
  BlockSystem system_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd diagonal_;
};

GraphSolution ToSolution(const GraphPoses& poses, std::size_t num_submaps, int num_iterations,
                         double initial_cost, double final_cost) {
  const auto first_node = poses.all().begin() + static_cast<std::ptrdiff_t>(num_submaps);
  return {{poses.all().begin(), first_node},
          {first_node, poses.all().end()},
          num_iterations,
          initial_cost,
          final_cost};
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
  GraphPoses poses;
  double cost = 0.0;
  double gain = 0.0;  ///< share of the gain that the quadratic promised
};

/// Nothing if the damped quadratic has no minimum.
std::optional<Trial> TryStep(LeastSquares* least_squares, const GraphPoses& poses, double cost,
                             const TrustRegion& region) {
  const Eigen::VectorXd damping = region.DampingOf(least_squares->diagonal());
  if (!least_squares->system().Factorize(damping)) return std::nullopt;
  const Eigen::VectorXd& gradient = least_squares->gradient();
  const Eigen::VectorXd step = -least_squares->system().Solve(gradient);
  const double promised = 0.5 * (step.dot(damping.cwiseProduct(step)) - step.dot(gradient));
  Trial trial{least_squares->unknowns().Moved(poses, step), 0.0, 0.0};
  trial.cost = least_squares->Cost(trial.poses);
  trial.gain = promised > 0.0 ? (cost - trial.cost) / promised : 0.0;
  return trial;
}

/// The inverse of H at the block of `unknown`; nothing if H is singular but for rounding.
std::optional<Eigen::Matrix3d> CovarianceOf(const GraphProblem& problem, int unknown,
                                            LeastSquares* least_squares) {
  constexpr double kMaxResidual = 1e-3;
  least_squares->Linearize(GraphPoses(problem));
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
  return next;
}

double CostOf(const GraphProblem& problem, const OptimizationProblemOptions& options) {
  const LeastSquares least_squares(problem, options.huber_scale);
  const GraphPoses poses(problem);
  return least_squares.HeldCost(poses) + least_squares.Cost(poses);
}

GraphSolution SolveGraph(const GraphProblem& problem, const OptimizationProblemOptions& options,
                         const SolverLimits& limits) {
  assert(!problem.global_from_submap.empty() && problem.num_held_submaps >= 1);
  LeastSquares least_squares(problem, options.huber_scale);
  GraphPoses poses(problem);
  const double held_cost = least_squares.HeldCost(poses);
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
  return ToSolution(poses, problem.global_from_submap.size(), num_iterations,
                    held_cost + initial_cost, held_cost + cost);
}

std::optional<Eigen::Matrix3d> CovarianceOfNode(const GraphProblem& problem,
                                                const OptimizationProblemOptions& options,
                                                NodeId node) {
  if (node.index < problem.num_held_nodes) return Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  LeastSquares least_squares(problem, options.huber_scale);
  return CovarianceOf(problem, least_squares.unknowns().of(node), &least_squares);
}

std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const GraphProblem& problem,
                                                  const OptimizationProblemOptions& options,
                                                  SubmapId submap) {
  if (submap.index < problem.num_held_submaps) return Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  LeastSquares least_squares(problem, options.huber_scale);
  return CovarianceOf(problem, least_squares.unknowns().of(submap), &least_squares);
}

}  // namespace loopscope
