// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/main_window.h"

#include <stdexcept>

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/session/render_command_line.h"
#include "app/studio/bars.h"
#include "app/studio/export_dialog.h"
#include "app/studio/inspector_panel.h"
#include "app/studio/layers_panel.h"
#include "app/studio/options_dialog.h"
#include "app/studio/palette_dialog.h"
#include "app/studio/table_panel.h"
#include "app/studio/theme.h"
#include "app/studio/timeline_widget.h"

namespace loopscope {
namespace {

constexpr int kMaxTiles = 4;
constexpr int kTickMilliseconds = 30;
constexpr int kPanelsMilliseconds = 150;

RunLine RunIn(MainWindow* window) {
  return [window](const std::string& line) { window->Run(line); };
}

}  // namespace

MainWindow::MainWindow() {
  setWindowTitle("Loopscope");
  setAcceptDrops(true);
  resize(1280, 800);
  actions_ = std::make_unique<Actions>(this, RunIn(this));
  setCentralWidget(MakeCentral());
  MakeToolBar();
  MakeDocks();
  pointer_ = new QLabel(this);
  mapping_bar_ = new MappingBar(RunIn(this), this);
  statusBar()->addWidget(pointer_, 1);
  statusBar()->addPermanentWidget(mapping_bar_);
  connect(&worker_, &SceneWorker::Drawn, this, [this](int tile) { tiles_[tile]->TakeScene(); });
  connect(&play_timer_, &QTimer::timeout, this, &MainWindow::Tick);
  play_timer_.setInterval(kTickMilliseconds);
  connect(&panels_timer_, &QTimer::timeout, this, &MainWindow::RefreshPanels);
  panels_timer_.setSingleShot(true);
  panels_timer_.setInterval(kPanelsMilliseconds);
  connect(&export_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          &MainWindow::EndExport);
  ConnectOpener();
  Restore();
  Refresh();
}

// Docks tell when they are hidden, to which the window listens as long as it is whole.
MainWindow::~MainWindow() { hide(); }

QWidget* MainWindow::MakeCentral() {
  pages_ = new QStackedWidget(this);
  pages_->addWidget(MakeStart());
  auto* const tiles = new QWidget(this);
  grid_ = new QGridLayout(tiles);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(1);
  for (int i = 0; i < kMaxTiles; ++i) {
    tiles_.push_back(new Tile(i, &worker_, RunIn(this), tiles));
    connect(tiles_[i], &Tile::Pointed, this, [this](const QString& text) {
      pointer_->setText(text);
    });
    connect(tiles_[i]->view(), &ViewWidget::Resized, this, [this, i] {
      if (static_cast<std::size_t>(i) < num_tiles_shown_) tiles_[i]->Show(session_);
    });
  }
  pages_->addWidget(tiles);

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

/// What a window says that shows nothing yet.
QWidget* MainWindow::MakeStart() {
  auto* const page = new QWidget(this);
  auto* const title = new QLabel("<h2>Why did that loop close, or not?</h2>"
                                 "<p>Open a scan log to map it, or a recording of a run.<br>"
                                 "You can also drop a file onto this window.</p>");
  title->setAlignment(Qt::AlignCenter);
  auto* const open = new QPushButton("Open a log or recording…");
  auto* const demo = new QPushButton("Try the demo");
  open->setDefault(true);
  for (QPushButton* const button : {open, demo}) button->setMinimumSize(220, 36);
  connect(open, &QPushButton::clicked, this, [this] { Run("file.open"); });
  connect(demo, &QPushButton::clicked, this, [this] { Run("file.demo"); });
  auto* const column = new QVBoxLayout(page);
  column->addStretch();
  column->addWidget(title);
  column->addSpacing(12);
  column->addWidget(open, 0, Qt::AlignCenter);
  column->addWidget(demo, 0, Qt::AlignCenter);
  column->addStretch();
  return page;
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

QDockWidget* MainWindow::AddDock(const char* title, QWidget* content, Qt::DockWidgetArea area) {
  auto* const dock = new QDockWidget(title, this);
  dock->setObjectName(title);
  dock->setWidget(content);
  dock->setTitleBarWidget(new QWidget(dock));  // its tab says what it is
  addDockWidget(area, dock);
  actions_->AddToWindowMenu(dock->toggleViewAction());
  return dock;
}

void MainWindow::MakeDocks() {
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  layers_ = new LayersPanel(RunIn(this), this);
  inspector_ = new InspectorPanel(&worker_, this);
  QDockWidget* const inspector = AddDock("Inspector", inspector_, Qt::RightDockWidgetArea);
  QDockWidget* const layers = AddDock("Layers", layers_, Qt::RightDockWidgetArea);
  tabifyDockWidget(inspector, layers);
  QDockWidget* first = nullptr;
  for (const auto& [kind, title] : {std::pair(TableKind::kLoops, "Loops"),
                                    std::pair(TableKind::kSubmaps, "Submaps"),
                                    std::pair(TableKind::kNodes, "Nodes")}) {
    tables_.push_back(new TablePanel(kind, RunIn(this), this));
    QDockWidget* const dock = AddDock(title, tables_.back(), Qt::BottomDockWidgetArea);
    connect(dock, &QDockWidget::visibilityChanged, this, [this] { Refresh(); });
    connect(tables_.back(), &TablePanel::SelectionActivated, inspector, &QWidget::raise);
    if (first != nullptr) tabifyDockWidget(first, dock);
    if (first == nullptr) first = dock;
  }
  first->raise();
  inspector->raise();
  for (QDockWidget* const dock : {inspector, layers}) {
    connect(dock, &QDockWidget::visibilityChanged, this, [this] { Refresh(); });
  }
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  resizeDocks({inspector}, {380}, Qt::Horizontal);
  resizeDocks({first}, {210}, Qt::Vertical);
}

void MainWindow::ConnectOpener() {
  connect(&opener_, &RunOpener::Reading, this,
          [this](const QString& path) { pointer_->setText("Reading " + path + " …"); });
  connect(&opener_, &RunOpener::Opened, this,
          [this](const std::string& path, const std::shared_ptr<Recording>& recording) {
            worker_.Load(*recording);
            session_.Load(path, *recording);
            for (Tile* const tile : tiles_) tile->Forget();
            for (TablePanel* const table : tables_) table->Forget();
            inspector_->Forget();
            message_bar_->Tell("");
            pointer_->clear();
            setWindowTitle(QString::fromStdString(recording->log().name + " – " + path) +
                           " – Loopscope");
            Refresh();
          });
  connect(&opener_, &RunOpener::Grown, this, [this](const std::vector<SlamUpdate>& updates) {
    for (const SlamUpdate& update : updates) {
      worker_.Append(update);
      session_.Append(update);
    }
    mapping_bar_->Show(opener_.progress(), opener_.seconds());
    Refresh();
  });
  connect(&opener_, &RunOpener::Mapped, this, [this](const QString& summary) {
    pointer_->setText(summary);
    Refresh();
  });
  connect(&opener_, &RunOpener::Failed, this, [this](const QString& message) {
    pointer_->clear();
    message_bar_->Tell(message);
  });
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
         export_.state() == QProcess::NotRunning && !panels_timer_.isActive();
}

/// Shows the session as it is now in every part of the window.
void MainWindow::Refresh() {
  pages_->setCurrentIndex(session_.has_recording() ? 1 : 0);
  timeline_->setVisible(session_.has_recording());
  mapping_bar_->setVisible(opener_.IsMapping());
  actions_->Show(session_);
  actions_->of("file.stop_mapping")->setEnabled(opener_.IsMapping());
  actions_->of("play.toggle")->setIcon(IconOf(session_.playing() ? "play.pause" : "play.toggle"));
  ArrangeTiles();
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

void MainWindow::ArrangeTiles() {
  const std::size_t count = session_.state().tiles.size();
  if (count != num_tiles_shown_) {
    num_tiles_shown_ = count;
    for (const int i : {0, 1}) {
      grid_->setRowStretch(i, 0);
      grid_->setColumnStretch(i, 0);
    }
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      grid_->removeWidget(tiles_[i]);
      tiles_[i]->setVisible(i < count);
      if (i >= count) continue;
      const int row = static_cast<int>(i) / 2, column = static_cast<int>(i) % 2;
      grid_->addWidget(tiles_[i], row, column);
      grid_->setRowStretch(row, 1);
      grid_->setColumnStretch(column, 1);
    }
  }
  for (std::size_t i = 0; i < count; ++i) tiles_[i]->Show(session_);
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
        this, "Open a log or a recording", QString(),
        "Logs and recordings (*.log *.clf *.gz *.loopscope);;All files (*)");
  }
  if (file.isEmpty()) return;
  Remember(file.toStdString());
  opener_.Open(file.toStdString(), LoopscopePreset());
}

void MainWindow::OpenDemo() { opener_.Open(LOOPSCOPE_DEMO_LOG, LoopscopePreset()); }

void MainWindow::MapAgain() {
  OptionsDialog dialog(session_.recording().options(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  opener_.Map(session_.recording().log(), dialog.options(), session_.path());
}

void MainWindow::StopMapping() { opener_.StopMapping(); }

void MainWindow::Export(const std::string& path) {
  const ViewRequest request = *tiles_[session_.state().active_tile]->asked();
  if (!path.empty()) {
    StartExport(request, QString::fromStdString(path));
    return;
  }
  ExportDialog dialog(request, session_.path(), this);
  if (dialog.exec() == QDialog::Accepted) StartExport(dialog.request(), dialog.path());
}

/// Runs the very command that the window tells: what is exported is what it draws.
void MainWindow::StartExport(const ViewRequest& request, const QString& path) {
  if (export_.state() != QProcess::NotRunning) {
    message_bar_->Tell("The picture before is still being drawn.");
    return;
  }
  QStringList arguments;
  for (const std::string& argument :
       RenderArguments(session_.path(), request, path.toStdString())) {
    arguments.append(QString::fromStdString(argument));
  }
  pointer_->setText("Drawing " + path + " …");
  export_.start(QApplication::applicationDirPath() + "/loopscope", arguments);
}

void MainWindow::EndExport(int exit_code) {
  const QString error = QString::fromUtf8(export_.readAllStandardError()).trimmed();
  pointer_->setText(QString::fromUtf8(export_.readAllStandardOutput()).trimmed());
  if (exit_code != 0) message_bar_->Tell(error);
}

void MainWindow::CopyCommandLine() {
  const ViewRequest request = *tiles_[session_.state().active_tile]->asked();
  const std::string line =
      RenderCommandLine(session_.path(), request, ToString(request.view) + ".png");
  QApplication::clipboard()->setText(QString::fromStdString(line));
  pointer_->setText(QString::fromStdString("Copied: " + line));
}

void MainWindow::ShowKeys() { KeysDialog(this).exec(); }

void MainWindow::ShowPalette() {
  auto* const dialog = new PaletteDialog(session_, RunIn(this), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

std::string MainWindow::message() const {
  return message_bar_->isHidden() ? "" : message_bar_->text().toStdString();
}

void MainWindow::SetWindowTheme(const std::string& name) {
  const QString theme = QString::fromStdString(name);
  ApplyWindowTheme(theme);
  QSettings().setValue("theme", theme);
  actions_->MakeIcons();
}

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
  settings.setValue("layout", saveState());
  opener_.StopMapping();
  QMainWindow::closeEvent(event);
}

void MainWindow::Restore() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  restoreState(settings.value("layout").toByteArray());
  recent_ = new QMenu("Open recent", this);
  actions_->AddToFileMenu(recent_);
  FillRecent();
}

void MainWindow::Remember(const std::string& path) {
  constexpr int kMaxRecent = 10;
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  const QString file = QFileInfo(QString::fromStdString(path)).absoluteFilePath();
  recent.removeAll(file);
  recent.prepend(file);
  while (recent.size() > kMaxRecent) recent.removeLast();
  settings.setValue("recent", recent);
  FillRecent();
}

void MainWindow::FillRecent() {
  recent_->clear();
  for (const QString& file : QSettings().value("recent").toStringList()) {
    recent_->addAction(file, this, [this, file] { Run("file.open " + file.toStdString()); });
  }
  recent_->setEnabled(!recent_->isEmpty());
}

}  // namespace loopscope
