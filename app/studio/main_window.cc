// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/main_window.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <stdexcept>

#include "app/session/render_command_line.h"
#include "app/studio/bars.h"
#include "app/studio/export_dialog.h"
#include "app/studio/inspector_panel.h"
#include "app/studio/layers_panel.h"
#include "app/studio/options_dialog.h"
#include "app/studio/palette_dialog.h"
#include "app/studio/recent_files.h"
#include "app/studio/start_page.h"
#include "app/studio/table_panel.h"
#include "app/studio/theme.h"
#include "app/studio/timeline_widget.h"

namespace loopscope {
namespace {

constexpr int kTickMilliseconds = 30;
constexpr int kPanelsMilliseconds = 150;
constexpr int kLayoutVersion = 2;  // counts changes of what docks and bars there are

RunLine RunIn(MainWindow* window) {
  return [window](const std::string& line) { window->Run(line); };
}

}  // namespace

MainWindow::MainWindow() : docks_(this) {
  setWindowTitle("Loopscope");
  setAcceptDrops(true);
  resize(1280, 800);
  actions_ = std::make_unique<Actions>(this, RunIn(this));
  setCentralWidget(MakeCentral());
  MakeToolBar();
  MakeDocks();
  MakeStatusBar();
  MakeTimers();
  ConnectOpener();
  ConnectExporter();
  Restore();
  Refresh();
}

// Docks tell when they are hidden, to which the window listens as long as it is whole.
MainWindow::~MainWindow() { hide(); }

QWidget* MainWindow::MakeCentral() {
  pages_ = new QStackedWidget(this);
  pages_->addWidget(new StartPage(RunIn(this), this));
  tiles_ = new TileGrid(session_, &worker_, RunIn(this), this);
  connect(tiles_, &TileGrid::Pointed, this,
          [this](const QString& text) { pointer_->setText(text); });
  pages_->addWidget(tiles_);
  message_bar_ = new MessageBar(this);
  timeline_ = new TimelineWidget(this);
  connect(timeline_, &TimelineWidget::Sought, this,
          [this](int step) { Run("step.seek " + std::to_string(step)); });
  auto* const central = new QWidget(this);
  auto* const column = new QVBoxLayout(central);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(message_bar_);
  column->addWidget(pages_, 1);
  column->addWidget(timeline_);
  return central;
}

void MainWindow::MakeToolBar() {
  auto* const bar = addToolBar("Tools");
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setIconSize({18, 18});
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* const name : names) bar->addAction(actions_->of(name));
    bar->addSeparator();
  };
  add({"file.open"});
  add({"edit.undo", "edit.redo"});
  add({"step.first", "event.previous", "step.previous", "play.toggle", "step.next", "event.next",
       "step.last"});
  play_bar_ = new PlayBar(RunIn(this), this);
  bar->addWidget(play_bar_);
  auto* const space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  add({"camera.fit", "camera.frame"});
  add({"tiles.one", "tiles.two", "tiles.four"});
  add({"file.export", "file.copy_command"});
  add({"help.palette"});
}

void MainWindow::MakeDocks() {
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  layers_ = new LayersPanel(RunIn(this), this);
  inspector_ = new InspectorPanel(&worker_, this);
  QDockWidget* const inspector = docks_.Add("Inspector", inspector_, Qt::RightDockWidgetArea);
  docks_.Add("Layers", layers_, Qt::RightDockWidgetArea);
  MakeTables(inspector);
  docks_.Arrange();
  QList<QAction*> toggles;
  for (QDockWidget* const dock : docks_.all()) {
    toggles.append(dock->toggleViewAction());
    connect(dock, &QDockWidget::visibilityChanged, this, [this] { Refresh(); });
  }
  actions_->AddToViewMenu(toggles);
}

void MainWindow::MakeTables(QDockWidget* inspector) {
  for (const auto& [kind, title] :
       {std::pair(TableKind::kLoops, "Loops"), std::pair(TableKind::kSubmaps, "Submaps"),
        std::pair(TableKind::kNodes, "Nodes")}) {
    tables_.push_back(new TablePanel(kind, RunIn(this), this));
    QDockWidget* const dock = docks_.Add(title, tables_.back(), Qt::BottomDockWidgetArea);
    connect(tables_.back(), &TablePanel::SelectionActivated, inspector, &QWidget::raise);
    if (kind != TableKind::kLoops) continue;
    connect(tiles_, &TileGrid::Listed, dock, &QWidget::raise);
  }
}

void MainWindow::MakeStatusBar() {
  pointer_ = new QLabel(this);
  opening_bar_ =
      new WorkBar(RunIn(this), "file.stop_mapping", "Stop; what was mapped until now stays", this);
  export_bar_ =
      new WorkBar(RunIn(this), "file.stop_export", "Stop; what was filmed until now stays", this);
  statusBar()->addWidget(pointer_, 1);
  statusBar()->addPermanentWidget(export_bar_);
  statusBar()->addPermanentWidget(opening_bar_);
}

void MainWindow::MakeTimers() {
  connect(&play_timer_, &QTimer::timeout, this, &MainWindow::Tick);
  play_timer_.setInterval(kTickMilliseconds);
  connect(&panels_timer_, &QTimer::timeout, this, &MainWindow::RefreshPanels);
  panels_timer_.setSingleShot(true);
  panels_timer_.setInterval(kPanelsMilliseconds);
}

void MainWindow::ConnectOpener() {
  connect(&opener_, &RunOpener::Reading, this,
          [this](const QString& path) { opening_bar_->Show("Reading " + path, 0, 0); });
  connect(&opener_, &RunOpener::HasRead, this,
          [this](const std::string& path) { recent_->Add(path); });
  connect(&opener_, &RunOpener::Opened, this,
          [this](const std::string& path, const std::shared_ptr<Recording>& recording) {
            Load(path, *recording);
          });
  connect(&opener_, &RunOpener::Grown, this, [this](const std::vector<SlamUpdate>& updates) {
    for (const SlamUpdate& update : updates) {
      worker_.Append(update);
      session_.Append(update);
    }
    ShowMapping();
    Refresh();
  });
  connect(&opener_, &RunOpener::Mapped, this, [this](const QString& summary) {
    pointer_->setText(summary);
    Refresh();
  });
  connect(&opener_, &RunOpener::Failed, this, [this](const QString& message) {
    message_bar_->Tell(message);
    Refresh();
  });
}

void MainWindow::ConnectExporter() {
  connect(&exporter_, &Exporter::Progressed, this,
          [this](int percent) { export_bar_->Show("Filming", percent, 100); });
  connect(&exporter_, &Exporter::Ended, this, [this](const QString& summary) {
    pointer_->setText(summary);
    export_bar_->hide();
  });
  connect(&exporter_, &Exporter::Failed, this,
          [this](const QString& message) { message_bar_->Tell(message); });
}

void MainWindow::Restore() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  restoreState(settings.value("layout").toByteArray(), kLayoutVersion);
  session_.SetDark(settings.value("theme").toString() == "dark");
  recent_ = new RecentFiles(RunIn(this), this);
  actions_->AddToFileMenu(recent_);
}

void MainWindow::Load(const std::string& path, const Recording& recording) {
  worker_.Load(recording);
  session_.Load(path, recording);
  tiles_->Forget();
  for (TablePanel* const table : tables_) table->Forget();
  inspector_->Forget();
  message_bar_->Tell("");
  pointer_->clear();
  setWindowTitle(QString::fromStdString(recording.log().name + " – " + path) + " – Loopscope");
  Refresh();
}

void MainWindow::ShowMapping() {
  const MappingProgress progress = opener_.progress();
  opening_bar_->Show(TextOf(progress, opener_.seconds()), progress.num_steps,
                     std::max(1, progress.num_scans));
}

void MainWindow::Run(const std::string& line) {
  try {
    RunCommand(line, &session_, this);
    Refresh();
  } catch (const std::exception& error) {
    message_bar_->Tell(error.what());
  }
}

bool MainWindow::IsIdle() const {
  return !opener_.IsReading() && !opener_.IsMapping() && worker_.IsIdle() &&
         !exporter_.IsRunning() && !panels_timer_.isActive();
}

std::string MainWindow::message() const {
  return message_bar_->isHidden() ? "" : message_bar_->text().toStdString();
}

/// Shows the session as it is now in every part of the window.
void MainWindow::Refresh() {
  const bool is_opening = opener_.IsReading() || opener_.IsMapping();
  pages_->setCurrentIndex(session_.has_recording() ? 1 : 0);
  timeline_->setVisible(session_.has_recording());
  if (!is_opening) opening_bar_->hide();
  actions_->Show(session_);
  actions_->of("file.stop_mapping")->setEnabled(is_opening);
  actions_->of("file.stop_export")->setEnabled(exporter_.IsRunning());
  actions_->of("play.toggle")->setIcon(IconOf(session_.playing() ? "play.pause" : "play.toggle"));
  tiles_->Refresh();
  timeline_->Show(session_);
  play_bar_->Show(session_);
  layers_->Show(session_);
  if (!panels_timer_.isActive()) panels_timer_.start();
  if (session_.playing() && !play_timer_.isActive()) {
    since_tick_.start();
    play_timer_.start();
  }
}

/// Tables and inspector take longer than pictures of a run that is played or dragged allow.
void MainWindow::RefreshPanels() {
  inspector_->Show(session_);
  for (TablePanel* const table : tables_) table->Show(session_);
}

void MainWindow::Tick() {
  session_.Advance(since_tick_.restart() / 1000.0);
  if (!session_.playing()) play_timer_.stop();
  Refresh();
}

void MainWindow::Open(const std::string& path) {
  QString file = QString::fromStdString(path);
  if (file.isEmpty()) {
    file = QFileDialog::getOpenFileName(
        this, "Open a log or a recording", RecentFiles::Folder(),
        "Logs and recordings (*.log *.clf *.gz *.loopscope);;All files (*)");
  }
  if (!file.isEmpty()) opener_.Open(file.toStdString(), LoopscopePreset());
}

void MainWindow::OpenDemo() { opener_.Open(LOOPSCOPE_DEMO_LOG, LoopscopePreset()); }

void MainWindow::MapAgain() {
  OptionsDialog dialog(session_.recording().options(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  opener_.Map(session_.recording().log(), dialog.options(), session_.path());
}

void MainWindow::StopMapping() { opener_.Stop(); }

void MainWindow::Export(const std::string& path) {
  const ViewRequest request = tiles_->PictureOfActive();
  if (!path.empty()) {
    StartExport(RenderArguments(session_.path(), request, path), QString::fromStdString(path));
    return;
  }
  ExportDialog dialog(request, session_, this);
  if (dialog.exec() == QDialog::Accepted) StartExport(dialog.arguments(), dialog.path());
}

void MainWindow::StartExport(const std::vector<std::string>& arguments, const QString& path) {
  export_bar_->Show("Drawing " + path, 0, 0);
  exporter_.Start(arguments);
}

void MainWindow::StopExport() { exporter_.Stop(); }

void MainWindow::CopyCommandLine() {
  const ViewRequest request = tiles_->PictureOfActive();
  const std::string line =
      CommandLine(RenderArguments(session_.path(), request, ToString(request.view) + ".png"));
  QApplication::clipboard()->setText(QString::fromStdString(line));
  pointer_->setText(QString::fromStdString("Copied: " + line));
}

void MainWindow::ShowKeys() { KeysDialog(this).exec(); }

void MainWindow::ShowPalette() {
  auto* const dialog = new PaletteDialog(session_, RunIn(this), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void MainWindow::SetWindowTheme(const std::string& name) {
  const QString theme = QString::fromStdString(name);
  ApplyWindowTheme(theme);
  QSettings().setValue("theme", theme);
  session_.SetDark(name == "dark");
  actions_->MakeIcons();
}

void MainWindow::ResetLayout() { docks_.Arrange(); }

void MainWindow::Quit() { close(); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty()) Run("file.open " + urls.front().toLocalFile().toStdString());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", saveState(kLayoutVersion));
  opener_.Stop();
  exporter_.Stop();
  QMainWindow::closeEvent(event);
}

}  // namespace loopscope
