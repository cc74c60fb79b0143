// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QMainWindow>
#include <QProcess>
#include <QTimer>

#include "app/session/commands.h"
#include "app/session/session.h"
#include "app/studio/actions.h"
#include "app/studio/run_opener.h"
#include "app/studio/scene_worker.h"
#include "app/studio/tile.h"

class QDockWidget;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace loopscope {

class InspectorPanel;
class LayersPanel;
class MappingBar;
class MessageBar;
class PlayBar;
class TablePanel;
class TimelineWidget;

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
  void CopyCommandLine() override;
  void ShowKeys() override;
  void ShowPalette() override;
  void SetWindowTheme(const std::string& name) override;
  void Quit() override;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* MakeCentral();
  QWidget* MakeStart();
  void MakeToolBar();
  void MakeDocks();
  QDockWidget* AddDock(const char* title, QWidget* content, Qt::DockWidgetArea area);
  void ConnectOpener();
  void Restore();

  void Refresh();
  void RefreshPanels();
  void ArrangeTiles();
  void Tick();
  void StartExport(const ViewRequest& request, const QString& path);
  void EndExport(int exit_code);
  void Remember(const std::string& path);
  void FillRecent();

  Session session_;
  SceneWorker worker_;
  RunOpener opener_;
  std::unique_ptr<Actions> actions_;
  std::vector<Tile*> tiles_;
  std::size_t num_tiles_shown_ = 0;
  QStackedWidget* pages_ = nullptr;  // the start page, and the tiles
  QGridLayout* grid_ = nullptr;
  TimelineWidget* timeline_ = nullptr;
  PlayBar* play_bar_ = nullptr;
  MessageBar* message_bar_ = nullptr;
  MappingBar* mapping_bar_ = nullptr;
  LayersPanel* layers_ = nullptr;
  InspectorPanel* inspector_ = nullptr;
  std::vector<TablePanel*> tables_;
  QLabel* pointer_ = nullptr;
  QMenu* recent_ = nullptr;
  QProcess export_;
  QTimer play_timer_;
  QTimer panels_timer_;
  QElapsedTimer since_tick_;
};

}  // namespace loopscope
