// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/session/inspection_report.h"
#include "core/slam/recording.h"
#include "render/inspection.h"
#include "render/scene.h"
#include "render/view.h"

namespace loopscope {

/// How much there is of a search.
struct SearchSize {
  int num_visits = 0;
  int root_height = 0;
  int num_angular_steps = 0;
};

/// A picture that was asked for.
struct DrawnScene {
  ViewRequest request;
  std::optional<Scene> scene;
  std::optional<Inspector> inspector;  ///< of the scene
  std::optional<SearchSize> search;    ///< if it shows one
  std::string error;  ///< why there is none: what the request asks for does not exist
};

/// What the inspector tells about.
struct ReportSubject {
  int step = 0;
  std::optional<NodeId> node;
  std::optional<SubmapId> submap;  ///< with `node`: the pair
};
bool operator==(const ReportSubject& a, const ReportSubject& b);

/// Builds scenes and reports on a thread of its own, from a copy of the recording of its own. Of
/// several requests for a tile only the newest is worked on.
class SceneWorker : public QObject {
  Q_OBJECT

 public:
  SceneWorker();
  ~SceneWorker() override;

  /// From now on scenes are of this recording. Forgets what was asked for and drawn of another.
  void Load(const Recording& recording);
  /// Adds what one more scan caused.
  void Append(const SlamUpdate& update);

  /// `device_pixels` are drawn for a pixel of the request, in each direction.
  void Ask(int tile, const ViewRequest& request, int device_pixels);

  /// The newest scene of a tile that was drawn and not yet taken.
  std::optional<DrawnScene> Take(int tile);

  /// Asks for a report; one that was asked for before is forgotten.
  void AskReport(const ReportSubject& subject);
  std::optional<InspectionReport> TakeReport();

  /// Whether all that was asked for is drawn.
  bool IsIdle() const;

 signals:
  /// A scene of `tile` is there to be taken. Emitted on the worker's thread.
  void Drawn(int tile);
  /// There is a report to be taken. It comes twice if a part of it takes long.
  void Reported();

 private:
  struct Job {
    ViewRequest request;
    int device_pixels = 1;
  };
  struct Workplace;  // what only the worker's thread touches

  void Run();
  bool WorkOnce(Workplace* place);
  void Draw(int tile, const Job& job, int run, Workplace* place);
  void Prefetch(Workplace* place);
  void Report(const ReportSubject& subject, int run, const Recording& recording);
  void MakeReport(const ReportSubject& subject, int run, const Recording& recording);
  bool Publish(int run, const InspectionReport& report);

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  int run_ = 0;  // counts recordings
  std::unique_ptr<Recording> loaded_;
  std::deque<SlamUpdate> updates_;
  std::map<int, Job> jobs_;
  std::map<int, DrawnScene> drawn_;
  std::optional<ReportSubject> report_job_;
  std::optional<InspectionReport> report_;
  bool is_drawing_ = false;
  std::thread thread_;
};

}  // namespace loopscope
