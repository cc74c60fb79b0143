// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeWidget>
#include <optional>

#include "app/session/session.h"
#include "app/studio/scene_worker.h"

namespace loopscope {

/// Everything known about what is selected, and about the step that is looked at.
class InspectorPanel : public QTreeWidget {
  Q_OBJECT

 public:
  /// Has reports made by `worker`, which has to live longer.
  explicit InspectorPanel(SceneWorker* worker, QWidget* parent = nullptr);

  /// Asks for the report of the session if it is another than that which is shown.
  void Show(const Session& session);
  /// As if nothing had been asked for yet.
  void Forget() { asked_.reset(); }

 private:
  void TakeReport();

  SceneWorker* worker_;
  std::optional<ReportSubject> asked_;
};

}  // namespace loopscope
