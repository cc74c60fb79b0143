// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/pause.h"
#include "app/session/session_state.h"
#include "app/session/timeline.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"
#include "render/view.h"

namespace loopscope {

/// A recording and what a person looks at of it. A window shows it; commands (commands.h) change
/// it; a test asserts it. It knows no window, and belongs to one thread.
class Session {
 public:
  /// Looks at `recording`, which is kept in the file at `path`, from its last step. What was
  /// undone or selected before is forgotten; how views are drawn stays.
  void Load(std::string path, Recording recording);

  /// Adds what one more scan caused to a recording that is still being made. Who looks at its last
  /// step goes on to the new one.
  void Append(const SlamUpdate& update);

  /// Whether there is a recording with a step to look at.
  bool has_steps() const { return recording_ && recording_->num_steps() > 0; }
  bool has_recording() const { return recording_ != nullptr; }
  const Recording& recording() const { return *recording_; }
  const std::string& path() const { return path_; }
  const Timeline& timeline() const { return timeline_; }
  int last_step() const { return has_recording() ? recording_->num_steps() - 1 : -1; }

  const SessionState& state() const { return state_; }
  /// Replaces the state; with another pair, all of its search is shown again, and loops marked
  /// beside the former one no longer are. Consecutive changes of the same `what`, such as steps,
  /// are undone at once.
  void Change(const std::string& what, SessionState state);
  bool can_undo() const { return !undone_from_.empty(); }
  bool can_redo() const { return !redone_from_.empty(); }
  void Undo();
  void Redo();

  /// The map as it was after the step that is looked at; there must be one.
  const MapState& map() const;

  /// The picture of a tile, but for its size.
  ViewRequest RequestOf(int tile) const;

  /// Pictures have dark paper if the window is dark. It is no part of the state that is undone.
  void SetDark(bool dark) { dark_ = dark; }

  /// The candidate of the selected pair; nothing if no pair is selected, or it never came up.
  std::optional<int> SelectedCandidate() const;

  // Playing.
  bool playing() const { return playing_; }
  double scans_per_second() const { return scans_per_second_; }
  const PauseConditions& pause_conditions() const { return pause_conditions_; }
  void Play(bool playing);
  void SetSpeed(double scans_per_second);
  void SetPauseConditions(const PauseConditions& conditions) { pause_conditions_ = conditions; }
  /// Goes on as far as `seconds` are worth, or until the end or a step with an event to pause at.
  void Advance(double seconds);

 private:
  struct Past {
    std::string what;
    SessionState state;
  };

  void SelectForStep(ViewRequest* request) const;

  std::string path_;
  std::unique_ptr<Recording> recording_;
  Timeline timeline_;
  SessionState state_;
  mutable std::optional<MapState> map_;  // derived when it is asked for
  bool dark_ = false;
  std::vector<Past> undone_from_;
  std::vector<Past> redone_from_;
  bool playing_ = false;
  double scans_per_second_ = 20.0;
  double unplayed_scans_ = 0.0;  // less than one
  PauseConditions pause_conditions_;
};

}  // namespace loopscope
