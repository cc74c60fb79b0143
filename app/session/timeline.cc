// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/timeline.h"

#include <algorithm>
#include <tuple>

namespace loopscope {
namespace {

std::optional<Event::Kind> KindOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kTooFar:
    case Verdict::kNotSampled:
      return std::nullopt;
    case Verdict::kBelowMinScore:
      return Event::Kind::kLoopBelowScore;
    case Verdict::kAmbiguous:
    case Verdict::kFromBehind:
    case Verdict::kInconsistent:
      return Event::Kind::kLoopRefused;
    case Verdict::kAccepted:
      return Event::Kind::kLoopClosed;
  }
  return std::nullopt;
}

bool HappensBefore(const Event& a, const Event& b) {
  return std::tie(a.step, a.kind, a.index) < std::tie(b.step, b.kind, b.index);
}

}  // namespace

bool operator==(const Event& a, const Event& b) {
  return std::tie(a.step, a.kind, a.index) == std::tie(b.step, b.kind, b.index);
}

std::string ToString(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::kSubmapFinished:
      return "submap finished";
    case Event::Kind::kLoopBelowScore:
      return "loop below score";
    case Event::Kind::kLoopRefused:
      return "loop refused";
    case Event::Kind::kLoopClosed:
      return "loop closed";
    case Event::Kind::kOptimization:
      return "optimization";
  }
  return "";
}

void Timeline::Append(const Recording& recording) {
  const auto num_old = static_cast<std::ptrdiff_t>(events_.size());
  AppendSubmaps(recording);
  AppendCandidates(recording);
  AppendOptimizations(recording);
  // New events are of later steps than old ones.
  std::sort(events_.begin() + num_old, events_.end(), HappensBefore);
}

void Timeline::AppendSubmaps(const Recording& recording) {
  // They are finished in the order in which they were begun.
  const auto& submaps = recording.submaps();
  while (num_submaps_ < static_cast<int>(submaps.size()) &&
         submaps[num_submaps_].finished_step >= 0) {
    events_.push_back(
        {submaps[num_submaps_].finished_step, Event::Kind::kSubmapFinished, num_submaps_});
    ++num_submaps_;
  }
}

void Timeline::AppendCandidates(const Recording& recording) {
  const auto& candidates = recording.candidates();
  for (; num_candidates_ < static_cast<int>(candidates.size()); ++num_candidates_) {
    const LoopCandidate& candidate = candidates[num_candidates_];
    if (const auto kind = KindOf(candidate.verdict)) {
      events_.push_back({candidate.applied_step, *kind, num_candidates_});
    }
  }
}

void Timeline::AppendOptimizations(const Recording& recording) {
  const auto& optimizations = recording.optimizations();
  for (; num_optimizations_ < static_cast<int>(optimizations.size()); ++num_optimizations_) {
    events_.push_back(
        {optimizations[num_optimizations_].step, Event::Kind::kOptimization, num_optimizations_});
  }
}

std::optional<Event> Timeline::NextEvent(int step, const std::set<Event::Kind>& kinds) const {
  const auto later = std::partition_point(events_.begin(), events_.end(),
                                          [&](const Event& event) { return event.step <= step; });
  const auto found = std::find_if(later, events_.end(),
                                  [&](const Event& event) { return kinds.count(event.kind) > 0; });
  return found == events_.end() ? std::nullopt : std::optional<Event>(*found);
}

std::optional<Event> Timeline::PreviousEvent(int step, const std::set<Event::Kind>& kinds) const {
  const auto end = std::partition_point(events_.begin(), events_.end(),
                                        [&](const Event& event) { return event.step < step; });
  const auto found = std::find_if(std::make_reverse_iterator(end), events_.rend(),
                                  [&](const Event& event) { return kinds.count(event.kind) > 0; });
  return found == events_.rend() ? std::nullopt : std::optional<Event>(*found);
}

}  // namespace loopscope
