// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QProcess>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "app/session/commands.h"
#include "app/session/session.h"
#include "app/studio/actions.h"
#include "app/studio/docks.h"
#include "app/studio/exporter.h"
#include "app/studio/run_opener.h"
#include "app/studio/scene_worker.h"
#include "app/studio/tile_grid.h"

class QLabel;
class QStackedWidget;

namespace loopscope {

class InspectorPanel;
class LayersPanel;
class MessageBar;
class PlayBar;
class RecentFiles;
class TablePanel;
class TimelineWidget;
class WorkBar;

/// The window: shows a session, and runs commands on it.
class MainWindow : public QMainWindow, public SessionHost {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  Session& session() { return session_; }

  /// Runs a command; what is wrong with it is told in the message bar.
  void Run(const std::string& line);

  /// Whether nothing is being read, mapped or drawn.
  bool IsIdle() const;

  /// What the message bar says; empty if it is closed.
  std::string message() const;

  // SessionHost.
  void Open(const std::string& path) override;
  void OpenDemo() override;
  void MapAgain() override;
  void StopMapping() override;
  void Export(const std::string& path) override;
  void StopExport() override;
  void CopyCommandLine() override;
  void ShowKeys() override;
  void ShowPalette() override;
  void SetWindowTheme(const std::string& name) override;
  void ResetLayout() override;
  void Quit() override;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* MakeCentral();
  void MakeToolBar();
  void MakeDocks();
  void MakeTables(QDockWidget* inspector);
  void MakeStatusBar();
  void MakeTimers();
  void ConnectOpener();
  void ConnectExporter();
  void Restore();

  void Refresh();
  void RefreshPanels();
  void Tick();
  void Load(const std::string& path, const Recording& recording);
  void ShowMapping();
  void StartExport(const std::vector<std::string>& arguments, const QString& path);

  Session session_;
  SceneWorker worker_;
  RunOpener opener_;
  Exporter exporter_;
  std::unique_ptr<Actions> actions_;
  Docks docks_;
  QStackedWidget* pages_ = nullptr;  // the start page, and the tiles
  TileGrid* tiles_ = nullptr;
  TimelineWidget* timeline_ = nullptr;
  PlayBar* play_bar_ = nullptr;
  MessageBar* message_bar_ = nullptr;
  WorkBar* opening_bar_ = nullptr;
  WorkBar* export_bar_ = nullptr;
  LayersPanel* layers_ = nullptr;
  InspectorPanel* inspector_ = nullptr;
  std::vector<TablePanel*> tables_;
  RecentFiles* recent_ = nullptr;
  QLabel* pointer_ = nullptr;
  QTimer play_timer_;
  QTimer panels_timer_;
  QElapsedTimer since_tick_;
};

}  // namespace loopscope
