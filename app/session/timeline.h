// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/slam/recording.h"

namespace loopscope {

/// Something that happened at a step and is worth a tick.
struct Event {
  /// In the order in which they happen within a step.
  enum class Kind {
    kSubmapFinished,
    kLoopBelowScore,  ///< searched, and nothing matched well enough
    kLoopRefused,     ///< matched, but ambiguous or inconsistent
    kLoopClosed,
    kOptimization,
  };

  int step = 0;
  Kind kind = Kind::kSubmapFinished;
  int index = 0;  ///< of the submap, candidate or optimization in the recording
};

bool operator==(const Event& a, const Event& b);
inline bool operator!=(const Event& a, const Event& b) { return !(a == b); }

/// "submap finished", "loop below score", "loop refused", "loop closed", "optimization".
std::string ToString(Event::Kind kind);

/// The events of a recording; those of candidates that were not searched are left out.
class Timeline {
 public:
  /// Adds the events of the steps that the recording got since the last call.
  void Append(const Recording& recording);

  /// By step, kind and index.
  const std::vector<Event>& events() const { return events_; }

  /// The first event of one of these kinds after `step`.
  std::optional<Event> NextEvent(int step, const std::set<Event::Kind>& kinds) const;

  /// The last event of one of these kinds before `step`.
  std::optional<Event> PreviousEvent(int step, const std::set<Event::Kind>& kinds) const;

 private:
  void AppendSubmaps(const Recording& recording);
  void AppendCandidates(const Recording& recording);
  void AppendOptimizations(const Recording& recording);

  std::vector<Event> events_;
  int num_submaps_ = 0;  ///< looked at so far: these were finished
  int num_candidates_ = 0;
  int num_optimizations_ = 0;
};

}  // namespace loopscope
