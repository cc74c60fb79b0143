// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/revisits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/grid/cell.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

using SubmapPair = std::pair<int, int>;

/// Keeps the nearest two nodes of each pair of submaps.
class NearestNodes {
 public:
  explicit NearestNodes(const Recording& recording) : recording_(recording) {}

  /// Node i < j.
  void Add(int i, int j, double distance) {
    const Node& first = recording_.nodes()[i];
    const Node& second = recording_.nodes()[j];
    for (SubmapId a = first.first_submap; first.LiesIn(a); ++a.index) {
      for (SubmapId b = second.first_submap; second.LiesIn(b); ++b.index) {
        if (second.LiesIn(a) || first.LiesIn(b)) continue;
        if (recording_.submap(a).finished_step < 0) continue;  // then b has not finished either
        AddTo(SubmapPair(a.index, b.index), i, j, distance);
      }
    }
  }

  std::vector<Revisit> ToRevisits() const {
    std::vector<Revisit> revisits;
    for (const auto& [submaps, revisit] : nearest_) revisits.push_back(revisit);
    return revisits;
  }

 private:
  void AddTo(const SubmapPair& submaps, int i, int j, double distance) {
    const Revisit revisit{SubmapId{submaps.first}, SubmapId{submaps.second}, NodeId{i}, NodeId{j},
                          distance};
    const auto [entry, is_new] = nearest_.emplace(submaps, revisit);
    if (!is_new && distance < entry->second.distance) entry->second = revisit;
  }

  const Recording& recording_;
  std::map<SubmapPair, Revisit> nearest_;
};

/// A return, roughly: in which cell of a coarse lattice, and in which eighth of a turn the beam
/// went.
struct CoarseReturn {
  CellIndex cell;
  int octant = 0;
};

/// Where the scans of submaps have returns in the reference.
class CoarseReturns {
 public:
  CoarseReturns(const Recording& recording, const ReferencePoses& reference)
      : recording_(recording), reference_(reference) {}

  /// The share of the returns of `node` that have one of `submap` in the same or a next cell, and
  /// in the same or a next octant.
  double Overlap(SubmapId submap, NodeId node) {
    const std::vector<CoarseReturn> returns = ReturnsOf(node);
    if (returns.empty()) return 0.0;
    const OctantsOfCells& octants = OctantsOf(submap);
    const auto is_shared = [&](const CoarseReturn& seen) {
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          const auto found = octants.find({seen.cell.x + dx, seen.cell.y + dy});
          if (found != octants.end() && (found->second & OctantsAround(seen.octant)) != 0) {
            return true;
          }
        }
      }
      return false;
    };
    return static_cast<double>(std::count_if(returns.begin(), returns.end(), is_shared)) /
           static_cast<double>(returns.size());
  }

 private:
  using OctantsOfCells = std::map<std::pair<int, int>, unsigned>;  // a bit for each octant

  static unsigned BitOf(int octant) { return 1u << ((octant + 8) % 8); }
  static unsigned OctantsAround(int octant) {
    return BitOf(octant - 1) | BitOf(octant) | BitOf(octant + 1);
  }

  /// Some may be the same.
  std::vector<CoarseReturn> ReturnsOf(NodeId node) const {
    constexpr double kResolution = 0.25;  // [m]
    std::vector<CoarseReturn> returns;
    if (!reference_[node.index]) return returns;
    Pose2 pose = *reference_[node.index];
    pose.translation -= kResolution * (FirstPlace() / kResolution).array().round().matrix();
    if (!IsInMap(pose)) return returns;
    const RangeData range_data =
        Transform(pose, RangeDataOfStep(recording_, recording_.node(node).step));
    for (const Eigen::Vector2d& point : range_data.returns) {
      const Eigen::Vector2d beam = point - range_data.origin;
      const double eighths = std::atan2(beam.y(), beam.x()) / (0.25 * M_PI);  // -4 ... 4
      returns.push_back({CellOf(point, kResolution), FloorToInt(eighths + 4.0) % 8});
    }
    return returns;
  }

  /// [m] A reference may be in the coordinates of a country, too large for cells.
  const Eigen::Vector2d& FirstPlace() const {
    const auto is_known = [](const std::optional<Pose2>& pose) { return pose.has_value(); };
    return (*std::find_if(reference_.begin(), reference_.end(), is_known))->translation;
  }

  const OctantsOfCells& OctantsOf(SubmapId id) {
    const auto [entry, is_new] = octants_.try_emplace(id.index);
    if (!is_new) return entry->second;
    const Submap& submap = recording_.submap(id);
    for (int i = 0; i < submap.num_nodes; ++i) {
      for (const CoarseReturn& seen : ReturnsOf(NodeId{submap.first_node.index + i})) {
        entry->second[{seen.cell.x, seen.cell.y}] |= BitOf(seen.octant);
      }
    }
    return entry->second;
  }

  const Recording& recording_;
  const ReferencePoses& reference_;
  std::map<int, OctantsOfCells> octants_;  // by submap
};

}  // namespace

std::vector<Revisit> RevisitsOf(const Recording& recording, const ReferencePoses& reference,
                                const RevisitOptions& options) {
  const std::vector<double> ways = NodeWays(recording);
  NearestNodes nearest(recording);
  for (int j = 0; j < static_cast<int>(reference.size()); ++j) {
    for (int i = 0; reference[j] && i < j && ways[j] - ways[i] > options.min_way; ++i) {
      if (!reference[i]) continue;
      const double distance = (reference[i]->translation - reference[j]->translation).norm();
      if (distance < options.max_distance) nearest.Add(i, j, distance);
    }
  }
  std::vector<Revisit> revisits = nearest.ToRevisits();
  CoarseReturns returns(recording, reference);
  const auto is_apart = [&](const Revisit& revisit) {
    return returns.Overlap(revisit.first, revisit.second_node) < options.min_overlap &&
           returns.Overlap(revisit.second, revisit.first_node) < options.min_overlap;
  };
  revisits.erase(std::remove_if(revisits.begin(), revisits.end(), is_apart), revisits.end());
  return revisits;
}

std::vector<Revisit> RevisitsWithout(const Recording& recording,
                                     const std::vector<JudgedLoop>& loops,
                                     const std::vector<Revisit>& revisits) {
  std::set<SubmapPair> tied;
  for (const JudgedLoop& loop : loops) {
    const Node& node = recording.node(loop.node);
    for (SubmapId submap = node.first_submap; node.LiesIn(submap); ++submap.index) {
      tied.insert(std::minmax({loop.submap.index, submap.index}));
    }
  }
  std::vector<Revisit> others;
  for (const Revisit& revisit : revisits) {
    if (tied.count({revisit.first.index, revisit.second.index}) == 0) others.push_back(revisit);
  }
  return others;
}

}  // namespace loopscope
