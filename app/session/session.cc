// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/session.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/slam/derive.h"

namespace loopscope {
namespace {

constexpr std::size_t kMaxUndo = 200;

Theme Darkened(Theme theme) {
  return theme == Theme::kColorBlind ? Theme::kDarkColorBlind : Theme::kDark;
}

}  // namespace

void Session::Load(std::string path, Recording recording) {
  path_ = std::move(path);
  recording_ = std::make_unique<Recording>(std::move(recording));
  timeline_ = Timeline();
  timeline_.Append(*recording_);
  map_.reset();
  undone_from_.clear();
  redone_from_.clear();
  Play(false);
  state_.step = std::max(0, last_step());
  state_.node.reset();
  state_.submap.reset();
  state_.loops.clear();
  state_.search = SearchFilter();
  for (auto& [kind, settings] : state_.views) settings.camera.reset();
}

void Session::Append(const SlamUpdate& update) {
  const bool follows = state_.step >= last_step() && !playing_;
  recording_->Append(update);
  timeline_.Append(*recording_);
  if (follows) state_.step = last_step();
}

void Session::Change(const std::string& what, SessionState state) {
  if (state.node != state_.node || state.submap != state_.submap) {
    state.search = SearchFilter();
    if (state.loops == state_.loops) state.loops.clear();
  }
  if (state == state_) return;
  const bool goes_on = !undone_from_.empty() && undone_from_.back().what == what &&
                       redone_from_.empty() && !what.empty();
  if (!goes_on) undone_from_.push_back({what, state_});
  if (undone_from_.size() > kMaxUndo) undone_from_.erase(undone_from_.begin());
  redone_from_.clear();
  state_ = std::move(state);
}

void Session::Undo() {
  if (!can_undo()) return;
  redone_from_.push_back({undone_from_.back().what, state_});
  state_ = std::move(undone_from_.back().state);
  undone_from_.pop_back();
}

void Session::Redo() {
  if (!can_redo()) return;
  undone_from_.push_back({redone_from_.back().what, state_});
  state_ = std::move(redone_from_.back().state);
  redone_from_.pop_back();
}

const MapState& Session::map() const {
  assert(has_steps());
  if (!map_ || map_->step != state_.step) map_ = StateAfterStep(*recording_, state_.step);
  return *map_;
}

ViewRequest Session::RequestOf(int tile) const {
  ViewRequest request;
  request.view = state_.tiles[tile];
  request.step = state_.step;
  request.theme = dark_ ? Darkened(state_.theme) : state_.theme;
  if (request.view == ViewKind::kChart) request.chart = state_.chart;
  SelectForStep(&request);
  const auto settings = state_.views.find(request.view);
  if (settings == state_.views.end()) return request;
  request.layers = settings->second.layers;
  request.opacities = settings->second.opacities;
  if (settings->second.camera) {
    request.center = settings->second.camera->center;
    request.width_in_meters = settings->second.camera->width_in_meters;
    request.height_in_meters = settings->second.camera->height_in_meters;
  }
  return request;
}

/// What is selected is the subject of a view if it was there at the step, and fits the view.
void Session::SelectForStep(ViewRequest* request) const {
  const MapState& state = map();
  const bool has_node = state_.node && state_.node->index < state.num_nodes;
  const bool has_submap = state_.submap && state_.submap->index < state.num_submaps;
  switch (request->view) {
    case ViewKind::kMap:
    case ViewKind::kGraph:
    case ViewKind::kTime:
    case ViewKind::kChart:
      if (has_node) request->node = state_.node;
      if (has_submap) request->submap = state_.submap;
      for (const int loop : state_.loops) {
        const LoopCandidate& candidate = recording_->candidates()[loop];
        if (loop < state.num_candidates) {
          request->marked.push_back({candidate.node, candidate.submap});
        }
      }
      break;
    case ViewKind::kSubmap:
      if (has_submap) request->submap = state_.submap;
      break;
    case ViewKind::kUpdate:
      // The scan is that of the step; of its two submaps the selected one.
      if (has_submap && state.num_nodes > 0 &&
          recording_->nodes()[state.num_nodes - 1].LiesIn(*state_.submap)) {
        request->submap = state_.submap;
      }
      break;
    case ViewKind::kMatch:
      break;
    case ViewKind::kSearch:
      request->node = state_.node;
      request->submap = state_.submap;
      request->search = state_.search;
      break;
  }
}

std::optional<int> Session::SelectedCandidate() const {
  if (!has_recording() || !state_.node || !state_.submap) return std::nullopt;
  return recording_->FindCandidate(*state_.submap, *state_.node);
}

void Session::Play(bool playing) {
  playing_ = playing && state_.step < last_step();
  unplayed_scans_ = 0.0;
}

void Session::SetSpeed(double scans_per_second) {
  scans_per_second_ = std::clamp(scans_per_second, 0.1, 10000.0);
}

void Session::Advance(double seconds) {
  if (!playing_) return;
  unplayed_scans_ += seconds * scans_per_second_;
  SessionState next = state_;
  while (unplayed_scans_ >= 1.0 && playing_) {
    unplayed_scans_ -= 1.0;
    ++next.step;
    if (next.step >= last_step() || ShouldPause(*recording_, next.step, pause_conditions_)) {
      Play(false);
    }
  }
  next.step = std::min(next.step, last_step());
  Change("step", next);
  if (next.step >= last_step()) Play(false);
}

}  // namespace loopscope
