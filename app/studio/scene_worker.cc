// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/scene_worker.h"

#include <stdexcept>
#include <utility>

#include "render/derived_cache.h"
#include "render/views/selection.h"

namespace loopscope {

namespace {

SearchSize SearchSizeOf(DerivedCache* cache, const ViewRequest& request) {
  const auto [submap, node] = SearchedPairOf(cache->recording(), request);
  const DerivedCache::Search search = cache->SearchOf(submap, node);
  if (!search || search->trace.nodes.empty()) return {};
  return {static_cast<int>(search->trace.visits.size()), search->trace.nodes.front().height,
          search->trace.window.num_angular_steps};
}

}  // namespace

bool operator==(const ReportSubject& a, const ReportSubject& b) {
  return a.step == b.step && a.node == b.node && a.submap == b.submap;
}

struct SceneWorker::Workplace {
  std::unique_ptr<Recording> recording;
  std::unique_ptr<DerivedCache> cache;  // of `recording`
  bool has_prefetched = false;
};

SceneWorker::SceneWorker() : thread_([this] { Run(); }) {}

SceneWorker::~SceneWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void SceneWorker::Load(const Recording& recording) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    loaded_ = std::make_unique<Recording>(recording);
    ++run_;
    updates_.clear();
    jobs_.clear();
    drawn_.clear();
    report_job_.reset();
    report_.reset();
  }
  wake_.notify_all();
}

void SceneWorker::Append(const SlamUpdate& update) {
  const std::lock_guard<std::mutex> lock(mutex_);
  updates_.push_back(update);
}

void SceneWorker::Ask(int tile, const ViewRequest& request, int device_pixels) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_[tile] = {request, device_pixels};
  }
  wake_.notify_all();
}

std::optional<DrawnScene> SceneWorker::Take(int tile) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = drawn_.find(tile);
  if (found == drawn_.end()) return std::nullopt;
  DrawnScene scene = std::move(found->second);
  drawn_.erase(found);
  return scene;
}

bool SceneWorker::IsIdle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return jobs_.empty() && !report_job_ && !is_drawing_ && drawn_.empty() && !report_;
}

void SceneWorker::AskReport(const ReportSubject& subject) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    report_job_ = subject;
  }
  wake_.notify_all();
}

std::optional<InspectionReport> SceneWorker::TakeReport() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(report_, std::nullopt);
}

void SceneWorker::Run() {
  Workplace place;
  while (WorkOnce(&place)) {
  }
}

/// Takes what came in; draws one tile, else makes a report, else prepares one grid. False if the
/// worker is to stop.
bool SceneWorker::WorkOnce(Workplace* place) {
  std::optional<std::pair<int, Job>> job;
  std::optional<ReportSubject> report;
  int run = 0;
  {
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [&] {
      return stopping_ || loaded_ || !jobs_.empty() || report_job_ ||
             (place->cache && !place->has_prefetched);
    });
    if (stopping_) return false;
    if (loaded_) {
      place->recording = std::move(loaded_);
      place->cache = std::make_unique<DerivedCache>(*place->recording);
    }
    for (SlamUpdate& update : updates_) place->recording->Append(std::move(update));
    if (!updates_.empty() || !jobs_.empty()) place->has_prefetched = false;
    updates_.clear();
    if (!jobs_.empty()) {
      job = *jobs_.begin();
      jobs_.erase(jobs_.begin());
    } else {
      report = std::exchange(report_job_, std::nullopt);
    }
    is_drawing_ = job || report;
    run = run_;
  }
  if (job) {
    Draw(job->first, job->second, run, place);
  } else if (report) {
    Report(*report, run, *place->recording);
  } else if (place->cache) {
    Prefetch(place);
  }
  return true;
}

/// A grid that cannot be made is told of when a picture asks for it.
void SceneWorker::Prefetch(Workplace* place) {
  try {
    place->has_prefetched = !place->cache->Prefetch();
  } catch (const std::exception&) {
    place->has_prefetched = true;
  }
}

void SceneWorker::Draw(int tile, const Job& job, int run, Workplace* place) {
  DrawnScene drawn;
  drawn.request = job.request;
  try {
    drawn.scene = BuildScene(place->cache.get(), job.request, job.device_pixels);
    drawn.inspector.emplace(place->cache.get(), job.request, *drawn.scene);
    if (job.request.view == ViewKind::kSearch) {
      drawn.search = SearchSizeOf(place->cache.get(), job.request);
    }
  } catch (const std::exception& error) {
    drawn.error = error.what();
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_drawing_ = false;
    if (run != run_) return;
    drawn_[tile] = std::move(drawn);
  }
  emit Drawn(tile);
}

void SceneWorker::Report(const ReportSubject& subject, int run, const Recording& recording) {
  try {
    MakeReport(subject, run, recording);
  } catch (const std::exception& error) {
    Publish(run, {{"Error", {{"what", error.what(), {}}}}});
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  is_drawing_ = false;
}

void SceneWorker::MakeReport(const ReportSubject& subject, int run, const Recording& recording) {
  const MapState state = StateAfterStep(recording, subject.step);
  InspectionReport report;
  const bool has_node = subject.node && subject.node->index < state.num_nodes;
  const bool has_submap = subject.submap && subject.submap->index < state.num_submaps;
  if (has_node && has_submap) {
    report = ReportOnPair(recording, state, *subject.submap, *subject.node);
  } else if (has_node) {
    report = ReportOnNode(recording, state, *subject.node);
  } else if (has_submap) {
    report = ReportOnSubmap(recording, state, *subject.submap);
  }
  for (Section& section : ReportOnStep(recording, state)) report.push_back(std::move(section));
  if (Publish(run, report)) {
    report.push_back(ReportOnMatch(recording, subject.step));
    if (has_node) report.push_back(ReportOnCovariance(recording, state, *subject.node));
    if (has_submap && !has_node) {
      report.push_back(ReportOnCovariance(recording, state, *subject.submap));
    }
    Publish(run, report);
  }
}

/// False if something else is more urgent now.
bool SceneWorker::Publish(int run, const InspectionReport& report) {
  bool is_newest = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (run != run_) return false;
    is_newest = !report_job_ && jobs_.empty();
    report_ = report;
  }
  emit Reported();
  return is_newest;
}

}  // namespace loopscope
