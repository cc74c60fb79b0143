// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_hash.h"

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "core/slam/option_values.h"

namespace loopscope {
namespace {

// The fields are taken apart by structured bindings, so that whoever adds one finds out here that
// it must be hashed and stored.
class Hash {
 public:
  std::uint64_t value() const { return value_; }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>> Add(Number number) {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    for (const unsigned char byte : bytes) AddByte(byte);
  }
  void Add(const std::string& text) {
    Add(text.size());
    for (const char c : text) AddByte(static_cast<unsigned char>(c));
  }
  void Add(const Pose2& pose) {
    Add(pose.x());
    Add(pose.y());
    Add(pose.rotation);
  }
  void Add(NodeId id) { Add(id.index); }
  void Add(SubmapId id) { Add(id.index); }
  void Add(const BeamGeometry& beams) {
    const auto& [num_beams, first_angle, angle_increment] = beams;
    AddAll(num_beams, first_angle, angle_increment);
  }
  void Add(const LaserScan& scan) {
    const auto& [time, beam_geometry, ranges, num_odometry_before] = scan;
    AddAll(time, beam_geometry, ranges, num_odometry_before);
  }
  void Add(const OdometryReading& reading) {
    const auto& [time, pose] = reading;
    AddAll(time, pose);
  }
  void Add(const LogNote& note) {
    const auto& [what, count, first_line] = note;
    AddAll(what, count, first_line);
  }
  void Add(const Step& step) {
    const auto& [prior, correlative, pose, outcome, match_start, wide_walls, node] = step;
    AddAll(prior, correlative, pose, outcome, match_start, wide_walls, node);
  }
  void Add(const Node& node) {
    const auto& [step, pose, first_submap, num_submaps] = node;
    AddAll(step, pose, first_submap, num_submaps);
  }
  void Add(const Submap& submap) {
    const auto& [pose, first_node, num_nodes, finished_step] = submap;
    AddAll(pose, first_node, num_nodes, finished_step);
  }
  void Add(const LoopCandidate& candidate) {
    const auto& [submap, node, considered_step, applied_step, whole_submap, last_look,
                 linear_window, angular_window, guess, verdict, score, score_bound, min_score,
                 rival_score, num_supporters, searched, refined] = candidate;
    AddAll(submap, node, considered_step, applied_step, whole_submap, last_look, linear_window,
           angular_window, guess, verdict, score, score_bound, min_score, rival_score,
           num_supporters, searched, refined);
  }
  void Add(const Optimization& optimization) {
    const auto& [step, final, submaps, nodes, num_iterations, initial_cost, final_cost,
                 drift_share] = optimization;
    AddAll(step, final, submaps, nodes, num_iterations, initial_cost, final_cost,
           drift_share.linear, drift_share.angular);
  }
  template <typename Value>
  void Add(const std::optional<Value>& value) {
    Add(value.has_value());
    if (value) Add(*value);
  }
  template <typename Value>
  void Add(const std::vector<Value>& values) {
    Add(values.size());
    for (const Value& value : values) Add(value);
  }

  template <typename... Values>
  void AddAll(const Values&... values) {
    (Add(values), ...);
  }

 private:
  void AddByte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t HashOfRecording(const Recording& recording) {
  Hash hash;
  const auto& [name, beam_geometries, base_from_laser, scans, odometry, notes] = recording.log();
  hash.AddAll(name, beam_geometries, base_from_laser, scans, odometry, notes);
  hash.Add(OptionsToText(recording.options()));
  for (int step = 0; step < recording.num_steps(); ++step) hash.Add(recording.step(step));
  hash.AddAll(recording.nodes(), recording.submaps(), recording.candidates(),
              recording.optimizations());
  return hash.value();
}

}  // namespace loopscope
