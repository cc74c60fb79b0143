#pragma once
#include <optional>
#include <set>
#include <vector>
#include "core/slam/recording.h"
namespace loopscope {
struct Event {
  enum class Kind { kSubmapFinished, kLoopClosed, kLoopRefused, kLoopBelowScore, kOptimization };
  int step = 0;
  Kind kind = Kind::kSubmapFinished;
  int index = 0;
};
class Timeline {
 public:
  void Append(const Recording&) {}
  const std::vector<Event>& events() const { return events_; }
  std::optional<Event> NextEvent(int, const std::set<Event::Kind>&) const { return std::nullopt; }
  std::optional<Event> PreviousEvent(int, const std::set<Event::Kind>&) const { return std::nullopt; }
 private:
  std::vector<Event> events_;
};
struct PauseConditions { bool on_loop = false; bool on_rejection = false; std::optional<double> residual_above; };
inline bool ShouldPause(const Recording&, int, const PauseConditions&) { return false; }
}
